#include "packing/update.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include "packing/rounding.h"

namespace collage {
namespace {

/// The new instance, seen from the voxels.
class Newcomer {
 public:
  Newcomer(const Element& element, const Instance& instance)
      : solid_(element.solid()),
        index_(element.distance_index()),
        center_(instance.world_from_element(element.center())),
        radius_(instance.scale * element.size()),
        unit_from_world_(glm::transpose(glm::mat3_cast(instance.rotation)) * (1.0 / radius_)) {}

  [[nodiscard]] const dvec3& center() const { return center_; }
  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] dvec3 unit_from_world(const dvec3& point) const {
    return unit_from_world_ * (point - center_);
  }
  [[nodiscard]] bool holds(const dvec3& unit) const {
    return glm::dot(unit, unit) <= 1.0 && solid_.inside(unit);
  }
  /// The distance where it is below `clearance`, else `clearance`.
  [[nodiscard]] float nearer(const dvec3& unit, float clearance) const {
    const double error = ClosestPointIndex::error(unit);
    const auto closest = index_.find(unit, clearance / radius_ + error);
    if (!closest) {
      return clearance;
    }
    return std::min(clearance, rounded_down(std::max(0.0, closest->distance - error) * radius_));
  }

 private:
  const Solid& solid_;
  const ClosestPointIndex& index_;
  dvec3 center_;
  double radius_;
  glm::dmat3 unit_from_world_;
};

struct VoxelRange {
  glm::ivec3 first;
  /// One beyond.
  glm::ivec3 last;
};

/// The voxels with a sample point within `reach` of `center`.
VoxelRange voxels_within(const VoxelGrid& grid, const dvec3& center, double reach) {
  const dvec3 from = glm::floor((center - reach - grid.origin) / grid.voxel_side);
  const dvec3 to = glm::floor((center + reach - grid.origin) / grid.voxel_side) + 1.0;
  const dvec3 end(grid.size);
  return {glm::ivec3(glm::clamp(from, dvec3(0.0), end)),
          glm::ivec3(glm::clamp(to, dvec3(0.0), end))};
}

/// Updates the voxels of one block; returns how many were flagged.
std::size_t update_block(const VoxelGrid& grid, const ClearanceField::Block& block,
                         const VoxelRange& reach, const Newcomer& newcomer, SurfaceId id) {
  const glm::ivec3 first = glm::max(reach.first - block.first_voxel, glm::ivec3(0));
  const glm::ivec3 last =
      glm::min(reach.last - block.first_voxel, glm::ivec3(VoxelGrid::block_side));
  std::size_t flagged = 0;
  glm::ivec3 local;
  for (local.z = first.z; local.z < last.z; ++local.z) {
    for (local.y = first.y; local.y < last.y; ++local.y) {
      for (local.x = first.x; local.x < last.x; ++local.x) {
        const std::size_t slot = VoxelGrid::slot(local);
        float& clearance = block.clearance[slot];
        if (clearance < 0.0F) {
          continue;  // outside the target or inside an instance
        }
        const dvec3 point = grid.sample_point(block.first_voxel + local);
        const double to_sphere = glm::distance(point, newcomer.center()) - newcomer.radius();
        if (to_sphere >= clearance) {
          continue;
        }
        const dvec3 unit = newcomer.unit_from_world(point);
        if (newcomer.holds(unit)) {
          clearance = -1.0F;
          ++flagged;
          continue;
        }
        const float nearer = newcomer.nearer(unit, clearance);
        if (nearer < clearance) {
          clearance = nearer;
          block.nearest[slot] = id;
        }
      }
    }
  }
  return flagged;
}

}  // namespace

std::size_t update(ClearanceField& field, const Element& element, const Instance& instance,
                   SurfaceId id, double hole_clearance) {
  const VoxelGrid& grid = field.grid();
  const Newcomer newcomer(element, instance);
  const VoxelRange reach =
      voxels_within(grid, newcomer.center(), newcomer.radius() + hole_clearance);
  const glm::ivec3 first_block = reach.first / VoxelGrid::block_side;
  const glm::ivec3 block_span =
      (reach.last + (VoxelGrid::block_side - 1)) / VoxelGrid::block_side - first_block;

  std::vector<std::size_t> blocks;
  for (int z = 0; z < block_span.z; ++z) {
    for (int y = 0; y < block_span.y; ++y) {
      for (int x = 0; x < block_span.x; ++x) {
        const std::size_t index = grid.block_index(first_block + glm::ivec3(x, y, z));
        if (field.block_maximum(index) >= 0.0F) {
          blocks.push_back(index);
        }
      }
    }
  }
  std::vector<std::size_t> flagged(blocks.size());
  std::vector<float> maxima(blocks.size());
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t b) {
    flagged[b] = update_block(grid, field.block(blocks[b]), reach, newcomer, id);
    maxima[b] = field.scan_block(blocks[b]);
  });
  std::size_t total = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    field.set_block_maximum(blocks[b], maxima[b]);
    total += flagged[b];
  }
  return total;
}

}  // namespace collage
