#include "geometry/distance_grid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file.h"
#include "support/folder.h"
#include "support/meshes.h"

namespace collage {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

DistanceGrid ball_grid() {
  DistanceGrid grid;
  grid.size = {8, 9, 10};
  grid.origin = {-1.0, 2.5, 0.1};
  grid.voxel_side = 0.3;
  glm::ivec3 v;
  for (v.z = 0; v.z < grid.size.z; ++v.z) {
    for (v.y = 0; v.y < grid.size.y; ++v.y) {
      for (v.x = 0; v.x < grid.size.x; ++v.x) {
        const dvec3 middle = grid.origin + 0.5 * grid.voxel_side * dvec3(grid.size);
        grid.values.push_back(static_cast<float>(glm::distance(grid.center(v), middle) - 0.8));
      }
    }
  }
  return grid;
}

TEST(DistanceGrid, ReadsWhatItWrites) {
  const test::Folder folder;
  const DistanceGrid grid = ball_grid();
  write_distance_grid(folder / "ball.sdf", grid);
  const DistanceGrid read = read_distance_grid(folder / "ball.sdf");
  EXPECT_EQ(read.size, grid.size);
  EXPECT_EQ(read.origin, grid.origin);
  EXPECT_EQ(read.voxel_side, grid.voxel_side);
  EXPECT_EQ(read.values, grid.values);
}

TEST(DistanceGrid, TurnsTheThesisSignOver) {
  const test::Folder folder;
  DistanceGrid grid = ball_grid();
  const std::vector<float> values = grid.values;
  for (float& value : grid.values) {
    value = -value;
  }
  write_distance_grid(folder / "ball.sdf", grid);
  EXPECT_EQ(read_distance_grid(folder / "ball.sdf").values, values);
}

TEST(DistanceGrid, NeedsOnlyDimensionsAndDistances) {
  const test::Folder folder;
  std::string text = "3 3 3 # voxels\n";
  for (int i = 0; i < 27; ++i) {
    text += i == 13 ? " -1" : " 1";
  }
  write_file(folder / "a.sdf", text);
  const DistanceGrid grid = read_distance_grid(folder / "a.sdf");
  EXPECT_EQ(grid.origin, dvec3(0.0));
  EXPECT_EQ(grid.voxel_side, 1.0);
  EXPECT_EQ(grid.at({1, 1, 1}), -1.0F);
}

TEST(DistanceGrid, SaysWhatIsWrongAndWhere) {
  const test::Folder folder;
  const auto reading = [&](const char* text) {
    write_file(folder / "bad.sdf", text);
    return [path = folder / "bad.sdf"] { read_distance_grid(path); };
  };
  EXPECT_THAT(reading("3 3\n"), ThrowsMessage<Error>(HasSubstr("bad.sdf:2: ends where a number")));
  EXPECT_THAT(reading("3 3 0\n"), ThrowsMessage<Error>(HasSubstr("a side of 0 voxels")));
  EXPECT_THAT(reading("2000 2000 2000 1\n"), ThrowsMessage<Error>(HasSubstr("fewer than")));
  EXPECT_THAT(reading("3 3 3\n1 1 x 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1\n"),
              ThrowsMessage<Error>(HasSubstr("bad.sdf:2: 'x' is not a signed distance")));
  EXPECT_THAT(reading("3 3 3\n1 1 nan 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1\n"),
              ThrowsMessage<Error>(HasSubstr("'nan' is not a signed distance")));
  EXPECT_THAT(reading("3 3 3\n1 -1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1\n"),
              ThrowsMessage<Error>(HasSubstr("outermost voxels")));
}

TEST(DistanceGrid, SamplesASolid) {
  const Mesh mesh = test::box_mesh(dvec3(-1, -0.5, -0.5), dvec3(1, 0.5, 0.5));
  const Solid solid(mesh, dvec3(0.0), 1.3);
  const DistanceGrid grid = sample_distance_grid(solid, bounding_box(mesh), 20);
  EXPECT_EQ(grid.size, glm::ivec3(22, 12, 12));
  EXPECT_NEAR(grid.at({10, 5, 5}), -0.45, 1e-5);
  EXPECT_NEAR(grid.at({0, 5, 5}), 0.05, 1e-5);
}

}  // namespace
}  // namespace collage
