#include "packing/clearance_field.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include <tbb/parallel_for.h>

#include "base/error.h"
#include "base/memory.h"
#include "packing/rounding.h"

namespace collage {

ClearanceField::ClearanceField(const Target& target, const VoxelGrid& grid, Status& status)
    : grid_(grid) {
  const std::size_t blocks = grid_.block_count();
  const std::size_t voxels = blocks * VoxelGrid::block_voxels;
  require_memory(voxels * (sizeof(float) + sizeof(NearestSurface)), "the voxels",
                 "target.resolution");
  upper_.assign(voxels, -1.0F);
  nearest_.assign(voxels, NearestSurface(target_surface));
  leaves_ = std::bit_ceil(std::max(blocks, VoxelGrid::group_blocks));
  maxima_.assign(2 * leaves_, -1.0F);
  least_from_target_.assign(blocks, std::numeric_limits<float>::infinity());
  last_neighbours_.assign(blocks, 0);

  const glm::ivec3 n = grid_.groups();
  const std::size_t layer = static_cast<std::size_t>(n.x) * n.y;
  for (int z = 0; z < n.z; ++z) {
    if (status.stop_requested()) {
      throw Interrupted();
    }
    const std::size_t first = static_cast<std::size_t>(z) * layer;
    tbb::parallel_for(first, first + layer, [&](std::size_t group) { sample(target, group); });
    status.update(static_cast<double>(z + 1) / n.z, "distances");
  }
  for (std::size_t index = 0; index < blocks; ++index) {
    set_block_maximum(index, scan_block(index));
  }
  voxels_inside_ = static_cast<std::size_t>(
      std::count_if(upper_.begin(), upper_.end(), [](float c) { return c >= 0.0F; }));
}

void ClearanceField::sample(const Target& target, std::size_t group) {
  constexpr std::size_t side = VoxelGrid::group_side;
  std::array<std::pair<std::size_t, std::size_t>, side * side * side> slots;
  std::array<dvec3, slots.size()> points;
  std::array<double, slots.size()> clearances;
  std::size_t count = 0;
  const glm::ivec3 first_block = grid_.block_at(group * VoxelGrid::group_blocks);
  for (std::size_t i = 0; i < slots.size(); ++i) {
    // There and back again, so that each voxel is beside the one before it.
    const auto z = static_cast<int>(i / (side * side));
    const auto row = static_cast<int>(i / side % side);
    const auto in_row = static_cast<int>(i % side);
    const int last = static_cast<int>(side) - 1;
    const int y = z % 2 == 0 ? row : last - row;
    const int x = y % 2 == z % 2 ? in_row : last - in_row;
    const glm::ivec3 local(x, y, z);
    const glm::ivec3 voxel = first_block * VoxelGrid::block_side + local;
    if (glm::all(glm::lessThan(voxel, grid_.size))) {
      slots[count] = {grid_.block_index(voxel / VoxelGrid::block_side),
                      VoxelGrid::slot(local % VoxelGrid::block_side)};
      points[count++] = grid_.sample_point(voxel);
    }
  }
  target.clearances({points.data(), count}, {clearances.data(), count});
  for (std::size_t i = 0; i < count; ++i) {
    const auto [block, slot] = slots[i];
    const float clearance = rounded_down(clearances[i]);
    upper_[block * VoxelGrid::block_voxels + slot] = clearance;
    if (clearance >= 0.0F) {
      least_from_target_[block] = std::min(least_from_target_[block], clearance);
    }
  }
}

ClearanceField::Block ClearanceField::block(std::size_t index) {
  const std::size_t first = index * VoxelGrid::block_voxels;
  return {grid_.block_at(index) * VoxelGrid::block_side, &upper_[first], &nearest_[first]};
}

float ClearanceField::scan_block(std::size_t index) const {
  // As integers, floats that are -1 or not negative have the same order, and vector instructions.
  const float* first = &upper_[index * VoxelGrid::block_voxels];
  auto maximum = std::bit_cast<std::int32_t>(-1.0F);
  for (std::size_t slot = 0; slot < VoxelGrid::block_voxels; ++slot) {
    maximum = std::max(maximum, std::bit_cast<std::int32_t>(first[slot]));
  }
  return std::bit_cast<float>(maximum);
}

void ClearanceField::set_block_maximum(std::size_t index, float maximum) {
  std::size_t node = leaves_ + index;
  maxima_[node] = maximum;
  while (node > 1) {
    node /= 2;
    const float winner = std::max(maxima_[2 * node], maxima_[2 * node + 1]);
    if (maxima_[node] == winner) {
      return;
    }
    maxima_[node] = winner;
  }
}

void ClearanceField::add_neighbour(std::size_t block, SurfaceId id) {
  std::uint32_t& last = last_neighbours_[block];
  if (last == 0 || neighbours_[last].ids.back() != target_surface) {
    neighbours_.push_back({{}, last});
    last = static_cast<std::uint32_t>(neighbours_.size() - 1);
  }
  *std::ranges::find(neighbours_[last].ids, target_surface) = id;
}

void ClearanceField::close(const Peak& peak) {
  block(peak.block).upper[peak.slot] = 0.0F;
  set_block_maximum(peak.block, scan_block(peak.block));
}

std::optional<ClearanceField::Peak> ClearanceField::peak() const {
  const float maximum = maxima_[1];
  if (maximum <= 0.0F) {
    return std::nullopt;
  }
  std::size_t node = 1;
  while (node < leaves_ / VoxelGrid::group_blocks) {
    node = maxima_[2 * node] == maximum ? 2 * node : 2 * node + 1;
  }
  const std::size_t first_block = node * VoxelGrid::group_blocks - leaves_;
  Peak first{0, 0, maximum};
  int least = std::numeric_limits<int>::max();
  for (std::size_t b = first_block; b < first_block + VoxelGrid::group_blocks; ++b) {
    if (block_maximum(b) == maximum) {
      const float* upper = &upper_[b * VoxelGrid::block_voxels];
      const auto slot = static_cast<std::size_t>(
          std::find(upper, upper + VoxelGrid::block_voxels, maximum) - upper);
      const glm::ivec3 at =
          VoxelGrid::octant(b) * VoxelGrid::block_side + VoxelGrid::local_at(slot);
      const int place = (at.z * VoxelGrid::group_side + at.y) * VoxelGrid::group_side + at.x;
      if (place < least) {
        least = place;
        first.block = b;
        first.slot = slot;
      }
    }
  }
  return first;
}

dvec3 ClearanceField::sample_point(const Peak& peak) const {
  return grid_.sample_point(grid_.block_at(peak.block) * VoxelGrid::block_side +
                            VoxelGrid::local_at(peak.slot));
}

}  // namespace collage
