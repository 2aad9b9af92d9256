#include "support/exact_packer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <tbb/parallel_for.h>

#include "packing/climb.h"
#include "packing/rounding.h"

namespace collage::test {
namespace {

/// The voxels with a sample point within `reach` of `center`: from the first to one before the
/// second.
std::pair<glm::ivec3, glm::ivec3> voxels_within(const VoxelGrid& grid, const dvec3& center,
                                                double reach) {
  const dvec3 from = glm::floor((center - reach - grid.origin) / grid.voxel_side);
  const dvec3 to = glm::floor((center + reach - grid.origin) / grid.voxel_side) + 1.0;
  const dvec3 end(grid.size);
  return {glm::ivec3(glm::clamp(from, dvec3(0.0), end)),
          glm::ivec3(glm::clamp(to, dvec3(0.0), end))};
}

/// PlacedElement::distance() in another way.
float world_distance(const PlacedElement& placed, const dvec3& unit, double limit,
                     const ExactDistance& distance) {
  const double error = ClosestPointIndex::error(unit);
  const auto found = distance(placed.element(), unit, limit / placed.radius() + error);
  return found ? rounded_down(std::max(0.0, *found - error) * placed.radius())
               : std::numeric_limits<float>::infinity();
}

std::size_t update_block(const VoxelGrid& grid, const ClearanceField::Block& block,
                         const glm::ivec3& from, const glm::ivec3& to, const Sphere& reach,
                         const PlacedElement& placed, SurfaceId id, const ExactDistance& distance) {
  const glm::ivec3 first = glm::max(from - block.first_voxel, glm::ivec3(0));
  const glm::ivec3 last = glm::min(to - block.first_voxel, glm::ivec3(VoxelGrid::block_side));
  std::size_t flagged = 0;
  glm::ivec3 local;
  for (local.z = first.z; local.z < last.z; ++local.z) {
    for (local.y = first.y; local.y < last.y; ++local.y) {
      for (local.x = first.x; local.x < last.x; ++local.x) {
        const std::size_t slot = VoxelGrid::slot(local);
        float& clearance = block.upper[slot];
        const dvec3 point = grid.sample_point(block.first_voxel + local);
        if (clearance < 0.0F || glm::distance(point, reach.center) > reach.radius) {
          continue;
        }
        const dvec3 unit = placed.unit_from_world(point);
        if (placed.holds(unit)) {
          clearance = -1.0F;
          ++flagged;
          continue;
        }
        const float nearer = world_distance(placed, unit, clearance, distance);
        if (nearer < clearance) {
          clearance = nearer;
          block.nearest[slot] = NearestSurface(id);
        }
      }
    }
  }
  return flagged;
}

}  // namespace

std::optional<double> indexed_distance(const Element& element, const dvec3& unit, double limit) {
  const auto closest = element.distance_index().find(unit, limit);
  return closest ? std::optional(closest->distance) : std::nullopt;
}

std::size_t exact_update(ClearanceField& field, const Surfaces& surfaces, SurfaceId id,
                         const Hole& hole, const ExactDistance& distance) {
  const VoxelGrid& grid = field.grid();
  const PlacedElement placed = surfaces.placed(id);
  const Sphere reach{hole.center, 2.0 * hole.clearance * (1.0 + 1e-6)};
  const auto voxels = voxels_within(grid, reach.center, reach.radius);
  const auto& from = voxels.first;  // Clang 14 captures no structured bindings
  const auto& to = voxels.second;
  const glm::ivec3 first = from / VoxelGrid::block_side;
  const glm::ivec3 span = (to + (VoxelGrid::block_side - 1)) / VoxelGrid::block_side - first;
  std::vector<std::size_t> blocks;
  for (int z = 0; z < span.z; ++z) {
    for (int y = 0; y < span.y; ++y) {
      for (int x = 0; x < span.x; ++x) {
        const std::size_t index = grid.block_index(first + glm::ivec3(x, y, z));
        if (field.block_maximum(index) >= 0.0F) {
          blocks.push_back(index);
        }
      }
    }
  }
  std::vector<std::size_t> flagged(blocks.size());
  std::vector<float> maxima(blocks.size());
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t b) {
    flagged[b] = update_block(grid, field.block(blocks[b]), from, to, reach, placed, id, distance);
    maxima[b] = field.scan_block(blocks[b]);
  });
  std::size_t total = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    field.set_block_maximum(blocks[b], maxima[b]);
    total += flagged[b];
  }
  return total;
}

Packing exact_pack(const Target& target, ClearanceField& field,
                   std::span<const Ingredient> ingredients, const PackingOptions& options,
                   const ExactDistance& distance) {
  const double longest_side = target.box().longest_side();
  const Placer placer(ingredients, options, target.box());
  std::vector<const Element*> elements;
  for (const Ingredient& ingredient : ingredients) {
    elements.push_back(&ingredient.element);
  }
  Surfaces surfaces(target, elements);
  Packing packing;
  while (const auto peak = field.peak()) {
    const NearestSurface nearest = field.block(peak->block).nearest[peak->slot];
    Hole hole{field.sample_point(*peak), peak->upper, nearest.id()};
    packing.largest_hole = hole.clearance;
    if (hole.clearance - options.spacing * longest_side < options.threshold * longest_side ||
        peak->upper < placer.least_clearance()) {
      break;
    }
    if (options.climb) {
      std::vector<SurfaceId> all(surfaces.instances().size());
      std::iota(all.begin(), all.end(), target_surface + 1);
      hole = climbed(surfaces, hole, all, std::min(field.grid().voxel_side, hole.clearance));
    }
    const auto instance = placer.place(hole, surfaces.instances().size(), surfaces);
    if (!instance) {
      if (!placer.fits_elsewhere(hole)) {
        break;
      }
      field.close(*peak);
      continue;
    }
    surfaces.add(*instance);
    packing.voxels_inside_instances += exact_update(
        field, surfaces, static_cast<SurfaceId>(surfaces.instances().size()), hole, distance);
    if (options.climb && field.block(peak->block).upper[peak->slot] == peak->upper) {
      field.close(*peak);
    }
  }
  packing.instances = surfaces.take_instances();
  return packing;
}

}  // namespace collage::test
