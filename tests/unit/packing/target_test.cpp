#include "packing/target.h"

#include <gtest/gtest.h>

#include "packing/clearance_field.h"
#include "support/meshes.h"

namespace collage {
namespace {

TEST(MeshTarget, LaysTheResolutionOnTheLongestSideWithPadding) {
  const MeshTarget target(test::box_mesh(dvec3(10, 0, -1), dvec3(12, 1, -0.5)));
  const VoxelGrid grid = target.voxels(20, 0.0, 0);
  EXPECT_EQ(grid.size, glm::ivec3(22, 12, 7));
  EXPECT_DOUBLE_EQ(grid.voxel_side, 0.1);
  EXPECT_NEAR(grid.origin.x, 9.9, 1e-12);
}

TEST(MeshTarget, ClearanceIsTheDistanceToTheSurfaceInsideAndNegativeOutside) {
  const MeshTarget target(test::box_mesh(dvec3(-1), dvec3(1)));
  EXPECT_NEAR(target.clearance({0.2, 0, 0}), 0.8, 1e-5);
  EXPECT_LE(target.clearance({0.2, 0, 0}), 0.8);
  EXPECT_LT(target.clearance({1.2, 0, 0}), 0.0);
  EXPECT_EQ(target.direction_to_surface({0.2, 0, 0}), dvec3(1, 0, 0));
}

/// One by one and without a hint is the slow twin.
TEST(MeshTarget, ClearancesOfManyPointsAreThoseOfEach) {
  const MeshTarget target(test::torus_mesh(1.0, 0.4, 24, 12));
  Rng rng(4, 4);
  std::vector<dvec3> points;
  points.reserve(2000);
  for (int i = 0; i < 2000; ++i) {  // some near the one before, some far
    points.push_back(i % 4 == 0 ? test::random_point(rng, 1.4)
                                : points.back() + test::random_point(rng, 0.03));
  }
  std::vector<double> clearances(points.size());
  target.clearances(points, clearances);
  int inside = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double clearance = target.clearance(points[i]);
    ASSERT_EQ(clearances[i], clearance);
    if (clearance > 0.0) {
      ++inside;
      ASSERT_EQ(target.clearance_below(points[i], clearance * 1.0001), clearance);
      ASSERT_GE(target.clearance_below(points[i], clearance * 0.99), clearance);
    }
  }
  EXPECT_GT(inside, 100);
}

TEST(GridTarget, GivesTheFilesDistancesAndTheirSlope) {
  DistanceGrid grid;
  grid.size = {12, 12, 12};
  grid.voxel_side = 0.5;
  glm::ivec3 v;
  for (v.z = 0; v.z < 12; ++v.z) {
    for (v.y = 0; v.y < 12; ++v.y) {
      for (v.x = 0; v.x < 12; ++v.x) {
        grid.values.push_back(static_cast<float>(glm::distance(grid.center(v), dvec3(3.0)) - 2.0));
      }
    }
  }
  const GridTarget target(grid);
  const VoxelGrid voxels = target.voxels(100, 0.5, 1);
  EXPECT_EQ(voxels.size, grid.size);
  EXPECT_EQ(voxels.sample_point({3, 4, 5}), grid.center({3, 4, 5}));
  const dvec3 point = grid.center({7, 5, 5});
  EXPECT_NEAR(target.clearance(point), 2.0 - glm::distance(point, dvec3(3.0)), 1e-6);
  EXPECT_GT(target.direction_to_surface(point).x, 0.9);
  EXPECT_NEAR(target.volume(), 4.0 / 3.0 * 3.14159 * 8.0, 0.7);
  Status status;
  const ClearanceField field(target, voxels, status);
  EXPECT_NEAR(field.peak()->upper, 2.0, 0.5);
}

TEST(ClearanceField, CountsTheVoxelsInside) {
  Status status;
  const MeshTarget target(test::box_mesh(dvec3(0), dvec3(2, 1, 1)));
  const ClearanceField field(target, target.voxels(20, 0.0, 0), status);
  EXPECT_EQ(field.voxels_inside(), 2000U);
}

TEST(VoxelGrid, SamplePointsLieWithinTheJitteredShareOfTheirVoxel) {
  VoxelGrid grid;
  grid.size = {50, 50, 50};
  grid.jitter = 0.5;
  grid.seed = 9;
  Box offsets;
  for (int i = 0; i < 50; ++i) {
    for (int j = 0; j < 50; ++j) {
      const glm::ivec3 voxel(i, j, 7);
      offsets.include(grid.sample_point(voxel) - dvec3(voxel));
    }
  }
  EXPECT_GE(offsets.min.x, 0.25);
  EXPECT_LE(offsets.max.x, 0.75);
  EXPECT_NEAR(offsets.min.x, 0.25, 0.01);
  EXPECT_NEAR(offsets.max.z, 0.75, 0.01);
}

}  // namespace
}  // namespace collage
