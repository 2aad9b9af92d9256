#include "geometry/boxes.h"

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace collage {
namespace {

TEST(SquaredDistance, ToABoxIsZeroWithinIt) {
  const Box box{dvec3(0), dvec3(1, 2, 3)};
  EXPECT_EQ(squared_distance(box, {0.5, 2.0, 0.1}), 0.0);
  EXPECT_EQ(squared_distance(box, {0.5, 4.0, 0.1}), 4.0);
  EXPECT_EQ(squared_distance(box, {-1.0, 4.0, 6.0}), 14.0);
}

TEST(SquaredDistance, BetweenBoxesIsZeroWhereTheyMeet) {
  const Box box{dvec3(0), dvec3(1, 2, 3)};
  EXPECT_EQ(squared_distance(box, Box{dvec3(1, 2, 3), dvec3(9)}), 0.0);
  EXPECT_EQ(squared_distance(box, Box{dvec3(0.2), dvec3(0.3)}), 0.0);
  EXPECT_EQ(squared_distance(box, Box{dvec3(3, 3, 1), dvec3(4)}), 5.0);
  EXPECT_EQ(squared_distance(Box{dvec3(3, 3, 1), dvec3(4)}, box), 5.0);
}

TEST(BoxAround, HoldsAll) {
  const Mesh mesh = test::blob_mesh(1.0, 0.3, 8);
  for (const auto& boxes : {boxes_of_points(mesh.positions), boxes_of_triangles(mesh)}) {
    EXPECT_EQ(box_around(boxes).min, bounding_box(mesh).min);
    EXPECT_EQ(box_around(boxes).max, bounding_box(mesh).max);
  }
  EXPECT_GT(box_around({}).min.x, box_around({}).max.x);
}

}  // namespace
}  // namespace collage
