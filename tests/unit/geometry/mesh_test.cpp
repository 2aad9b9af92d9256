#include "geometry/mesh.h"

#include <gtest/gtest.h>

#include "test_meshes.h"

namespace collage {
namespace {

TEST(Mesh, CubeHasItsVolumeAreaAndBox) {
  const Mesh cube = make_cube({1, 2, 3}, 2.0);
  EXPECT_DOUBLE_EQ(enclosed_volume(cube), 8.0);
  EXPECT_DOUBLE_EQ(surface_area(cube), 24.0);
  EXPECT_EQ(bounding_box(cube).min, dvec3(1, 2, 3));
  EXPECT_EQ(bounding_box(cube).max, dvec3(3, 4, 5));
  EXPECT_EQ(bounding_box(cube).longest_side(), 2.0);
}

TEST(Mesh, VolumeDoesNotDependOnPlace) {
  EXPECT_NEAR(enclosed_volume(make_cube({1e6, -1e6, 1e6}, 1.0)), 1.0, 1e-9);
}

TEST(Mesh, ReversedMeshHasNegativeVolumeAndTurnedNormals) {
  Mesh cube = make_cube();
  cube.normals = {{0, 0, 1}};
  cube.normal_triangles.assign(12, {0, 0, 0});
  reverse_orientation(cube);
  EXPECT_DOUBLE_EQ(enclosed_volume(cube), -1.0);
  EXPECT_EQ(cube.normals[0], dvec3(0, 0, -1));
}

TEST(Mesh, EmptyMeshHasNoVolumeAndAnEmptyBox) {
  EXPECT_EQ(enclosed_volume({}), 0.0);
  EXPECT_EQ(surface_area({}), 0.0);
  EXPECT_GT(bounding_box({}).min.x, bounding_box({}).max.x);
}

TEST(Mesh, BoxLeavesOutUnusedPositions) {
  Mesh cube = make_cube();
  cube.positions.emplace_back(100, 100, 100);
  EXPECT_EQ(bounding_box(cube).max, dvec3(1, 1, 1));
}

}  // namespace
}  // namespace collage
