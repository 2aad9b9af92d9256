#include "packing/update.h"

#include <limits>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace collage {
namespace {

/// Every stored clearance against the exact distances to all surfaces, in double and without
/// hierarchy: never above the truth, and not below it by more than the rounding.
void expect_true_clearances(ClearanceField& field, const Mesh& target_mesh, const Mesh& element,
                            const std::vector<Instance>& instances) {
  std::size_t free = 0;
  for (std::size_t b = 0; b < field.grid().block_count(); ++b) {
    const ClearanceField::Block block = field.block(b);
    for (std::size_t slot = 0; slot < VoxelGrid::block_voxels; ++slot) {
      const float stored = block.clearance[slot];
      if (stored < 0.0F) {
        continue;
      }
      ++free;
      const dvec3 p = field.grid().sample_point(block.first_voxel + VoxelGrid::local_at(slot));
      double truth = std::numeric_limits<double>::infinity();
      const auto consider = [&](const Mesh& mesh, const Instance& placed) {
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
          const dvec3 closest =
              closest_point_on_triangle(p, placed.world_from_element(mesh.corner(t, 0)),
                                        placed.world_from_element(mesh.corner(t, 1)),
                                        placed.world_from_element(mesh.corner(t, 2)));
          truth = std::min(truth, glm::distance(p, closest));
        }
      };
      consider(target_mesh, Instance{});
      for (const Instance& instance : instances) {
        consider(element, instance);
      }
      ASSERT_LE(static_cast<double>(stored), truth);
      ASSERT_GE(static_cast<double>(stored), truth - 1e-5);
    }
  }
  EXPECT_GT(free, 100U);
}

TEST(Update, StoredClearancesAreNeverAboveTheTruth) {
  const Mesh target_mesh = test::blob_mesh(1.0, 0.2, 10);
  const Mesh mesh = test::torus_mesh(1.0, 0.3, 10, 6);
  Status status;
  const MeshTarget target(target_mesh);
  const Element element(mesh);
  ClearanceField field(target, target.voxels(20, 0.5, 3), status);
  std::vector<Instance> instances;
  for (int i = 0; i < 4; ++i) {
    const Hole hole = field.largest_hole();
    Instance instance;
    instance.scale = hole.clearance / element.size();
    instance.rotation = glm::normalize(glm::dquat(1.0, 0.3 * i, 0.2, -0.5 * i));
    instance.translation = hole.center - instance.rotation * (instance.scale * element.center());
    instances.push_back(instance);
    update(field, element, instance, static_cast<SurfaceId>(instances.size()), hole.clearance);
    expect_true_clearances(field, target_mesh, mesh, instances);
  }
}

TEST(Update, FlagsExactlyTheVoxelsInside) {
  Status status;
  const MeshTarget target(test::box_mesh(dvec3(-1), dvec3(1)));
  const Element ball(test::blob_mesh(1.0, 0.0, 24));
  ClearanceField field(target, target.voxels(40, 0.0, 0), status);
  Instance instance;
  instance.scale = 0.5;
  const std::size_t flagged = update(field, ball, instance, 1, 1.0);
  const double voxel = 2.0 / 40.0;
  const double volume = static_cast<double>(flagged) * voxel * voxel * voxel;
  EXPECT_NEAR(volume / (0.125 * ball.solid().volume()), 1.0, 0.02);
}

TEST(Update, TheLargestHoleIsTheLargestVoxelAfterwards) {
  Status status;
  const MeshTarget target(test::blob_mesh(1.0, 0.2, 10));
  const Element element(test::torus_mesh(1.0, 0.3, 10, 6));
  ClearanceField field(target, target.voxels(30, 0.5, 3), status);
  for (int i = 0; i < 5; ++i) {
    const Hole hole = field.largest_hole();
    Instance instance;
    instance.scale = hole.clearance / element.size();
    instance.translation = hole.center - instance.scale * element.center();
    update(field, element, instance, static_cast<SurfaceId>(i + 1), hole.clearance);
    float largest = -1.0F;
    for (std::size_t b = 0; b < field.grid().block_count(); ++b) {
      EXPECT_EQ(field.scan_block(b), field.block_maximum(b));
      largest = std::max(largest, field.scan_block(b));
    }
    EXPECT_EQ(field.largest_hole().clearance, static_cast<double>(largest));
  }
}

}  // namespace
}  // namespace collage
