#include <limits>

#include <tbb/parallel_for.h>

#include "bench/bar.h"
#include "packing/clearance_field.h"

namespace collage::bench {
namespace {

/// Of the blocks of a field, one in this many is sampled the slow way.
constexpr std::size_t sampled_share = 8;

/// One exact query and one fast winding number a voxel.
void sample_slowly(const MeshTarget& target, const VoxelGrid& grid) {
  const Solid& solid = target.solid();
  tbb::parallel_for(std::size_t{0}, grid.block_count() / sampled_share, [&](std::size_t block) {
    const glm::ivec3 first = grid.block_at(block * sampled_share) * VoxelGrid::block_side;
    for (std::size_t slot = 0; slot < VoxelGrid::block_voxels; ++slot) {
      const dvec3 point = grid.sample_point(first + VoxelGrid::local_at(slot));
      const dvec3 unit = solid.unit_from_mesh(point);
      const double distance =
          solid.surface().find(unit, std::numeric_limits<double>::infinity())->distance;
      volatile double kept = solid.inside_by_winding_number(unit) ? distance : -distance;
      static_cast<void>(kept);
    }
  });
}

std::vector<Bar> armadillo() {
  const MeshTarget target(field_mesh("targets/armadillo.obj"));
  const VoxelGrid grid = target.voxels(256, 0.5, 1);
  Status status;
  const double fast = measure(2, [&] { const ClearanceField field(target, grid, status); });
  const double slow = measure(2, [&] { sample_slowly(target, grid); }) * sampled_share;
  return {{"armadillo, 256 voxels: a query and a winding number a voxel", fast, "CPU s", slow,
           slow / fast, Bar::Side::at_least, 10.0}};
}

}  // namespace

std::vector<Group> signed_distance_bars() {
  return {{"signed-distance", armadillo, Group::Meshes::field}};
}

}  // namespace collage::bench
