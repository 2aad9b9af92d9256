#include "packing/update.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <tbb/parallel_for.h>

#include "geometry/boxes.h"
#include "packing/rounding.h"

namespace collage {
namespace {

/// The element's coarse grid serves instances of at most this many voxels across their radius.
constexpr double coarse_radius_voxels = 3.0;
/// A footprint of more blocks than this is worth being shared among threads.
constexpr std::size_t blocks_on_one_thread = 64;

/// The new instance, and the bounds on the distance to it.
class Newcomer {
 public:
  Newcomer(const PlacedElement& placed, const VoxelGrid& grid)
      : placed_(placed),
        radius_(static_cast<float>(placed.radius())),
        voxel_side_(static_cast<float>(grid.voxel_side)),
        detail_(placed.radius() < coarse_radius_voxels * grid.voxel_side
                    ? DistanceBounds::Detail::coarse
                    : DistanceBounds::Detail::fine) {}

  [[nodiscard]] const PlacedElement& placed() const { return placed_; }

  /// In world units, around the distance that PlacedElement::distance() finds.
  struct Bounds {
    float lower;
    float upper;
  };
  /// False where the distance is not below `limit`.
  [[nodiscard]] bool find(const dvec3& unit, float limit, Bounds& bounds) const {
    const glm::vec3 query(unit);
    const float error = float_error * (1.0F + glm::length(query));
    const DistanceBounds::Squared squared = squared_bounds(query);
    const float unit_limit = limit / radius_ * above_one + error;
    if (squared.lower >= unit_limit * unit_limit * above_one) {
      return false;
    }
    const float lower = std::sqrt(std::max(0.0F, squared.lower)) * below_one - error;
    bounds.lower = std::max(0.0F, lower) * radius_ * below_one;
    const float upper = std::sqrt(std::max(0.0F, squared.lower + squared.gap)) + error;
    bounds.upper = upper * radius_ * above_one;
    return true;
  }
  [[nodiscard]] NearestSurface nearest(SurfaceId id, const Bounds& bounds) const {
    return {id, (bounds.upper - bounds.lower) / voxel_side_ * above_one};
  }

 private:
  /// What is taken off a distance that was found exactly, and that rounding to float loses.
  static constexpr float float_error = 2e-6F;
  /// Outweigh the rounding of a few operations.
  static constexpr float below_one = 1.0F - 0x1p-21F;
  static constexpr float above_one = 1.0F + 0x1p-21F;

  [[nodiscard]] DistanceBounds::Squared squared_bounds(const glm::vec3& query) const {
    const float farthest = std::max({std::abs(query.x), std::abs(query.y), std::abs(query.z)});
    if (farthest < DistanceBounds::reach) {
      return placed_.element().distance_bounds().squared(query, detail_);
    }
    const float length = glm::length(query);  // within the unit ball: between length - 1 and + 1
    return {(length - 1.0F) * (length - 1.0F), 4.0F * length};
  }

  const PlacedElement& placed_;
  float radius_;
  float voxel_side_;
  DistanceBounds::Detail detail_;
};

/// Updates the voxels of one block.
class BlockUpdate {
 public:
  BlockUpdate(ClearanceField& field, const Surfaces& surfaces, SurfaceId id,
              const Newcomer& newcomer, float useless)
      : field_(field),
        surfaces_(surfaces),
        id_(id),
        newcomer_(newcomer),
        useless_(useless),
        voxel_side_(static_cast<float>(field.grid().voxel_side)) {}

  /// Returns the number of voxels flagged.
  std::size_t run(std::size_t index, std::vector<Update::Voxel>& before);

 private:
  struct Point {
    dvec3 world;
    dvec3 unit;
    double to_sphere;
  };

  void visit(std::size_t slot);
  void set_distance(std::size_t slot, const Point& at);
  void resolve(std::size_t slot, const Point& at, const Newcomer::Bounds& bounds);
  void keep(std::size_t slot, float upper, NearestSurface nearest) {
    before_->push_back({index_, slot, block_.upper[slot], block_.nearest[slot]});
    block_.upper[slot] = upper;
    block_.nearest[slot] = nearest;
  }

  ClearanceField& field_;
  const Surfaces& surfaces_;
  SurfaceId id_;
  const Newcomer& newcomer_;
  float useless_;
  float voxel_side_;

  std::size_t index_ = 0;
  ClearanceField::Block block_{};
  std::vector<Update::Voxel>* before_ = nullptr;
  std::size_t flagged_ = 0;
};

std::size_t BlockUpdate::run(std::size_t index, std::vector<Update::Voxel>& before) {
  index_ = index;
  block_ = field_.block(index);
  before_ = &before;
  flagged_ = 0;
  const VoxelGrid& grid = field_.grid();
  const PlacedElement& placed = newcomer_.placed();
  // From the voxels' centres, which are so near to the sample points.
  const double off_center = (0.5 * std::sqrt(3.0) * grid.jitter + 1e-4) * grid.voxel_side;
  const auto radius = static_cast<float>(placed.radius() + off_center);
  const float maximum = field_.block_maximum(index);
  const float reach = radius + (maximum < useless_ ? 0.0F : maximum);
  const dvec3 first_center = grid.origin + (dvec3(block_.first_voxel) + 0.5) * grid.voxel_side;
  const glm::vec3 first(first_center - placed.center());
  const auto side = static_cast<float>(grid.voxel_side);
  std::array<float, VoxelGrid::block_side> squared_x;
  for (int x = 0; x < VoxelGrid::block_side; ++x) {
    const float away = first.x + static_cast<float>(x) * side;
    squared_x[static_cast<std::size_t>(x)] = away * away;
  }
  for (int yz = 0; yz < VoxelGrid::block_side * VoxelGrid::block_side; ++yz) {
    const float y = first.y + static_cast<float>(yz % VoxelGrid::block_side) * side;
    const float z = first.z + static_cast<float>(yz / VoxelGrid::block_side) * side;
    const float squared_yz = y * y + z * z;
    if (squared_yz >= reach * reach) {
      continue;
    }
    const std::size_t row = static_cast<std::size_t>(yz) * VoxelGrid::block_side;
    const auto may_change = [&](std::size_t x) {
      const float upper = block_.upper[row + x];
      const float near = radius + (upper < useless_ ? 0.0F : upper);
      return static_cast<int>(upper >= 0.0F) &
             static_cast<int>(squared_x[x] + squared_yz < near * near);
    };
    int voxels = 0;  // counted by vector instructions
    for (std::size_t x = 0; x < VoxelGrid::block_side; ++x) {
      voxels += may_change(x);
    }
    for (std::size_t x = 0; voxels > 0; ++x) {
      if (may_change(x) != 0) {
        visit(row + x);
        --voxels;
      }
    }
  }
  return flagged_;
}

void BlockUpdate::visit(std::size_t slot) {
  const PlacedElement& placed = newcomer_.placed();
  Point at;
  at.world = field_.grid().sample_point(block_.first_voxel + VoxelGrid::local_at(slot));
  at.to_sphere = glm::distance(at.world, placed.center()) - placed.radius();
  if (at.to_sphere >= block_.upper[slot]) {
    return;
  }
  at.unit = placed.unit_from_world(at.world);
  if (placed.holds(at.unit)) {
    keep(slot, -1.0F, block_.nearest[slot]);
    ++flagged_;
    return;
  }
  if (block_.upper[slot] >= useless_) {
    set_distance(slot, at);
  }
}

void BlockUpdate::set_distance(std::size_t slot, const Point& at) {
  const float upper = block_.upper[slot];
  const NearestSurface nearest = block_.nearest[slot];
  Newcomer::Bounds bounds{};
  if (!newcomer_.find(at.unit, upper, bounds)) {
    return;
  }
  if (bounds.upper < nearest.lower(upper, voxel_side_)) {
    keep(slot, bounds.upper, newcomer_.nearest(id_, bounds));
  } else if (bounds.upper >= useless_) {
    resolve(slot, at, bounds);
  } else {
    keep(slot, bounds.upper, NearestSurface(id_));
  }
}

/// Asks the surface that was nearest, and the new one where that is not enough.
void BlockUpdate::resolve(std::size_t slot, const Point& at, const Newcomer::Bounds& bounds) {
  const SurfaceId before = block_.nearest[slot].id();
  float clearance = block_.upper[slot];
  if (!block_.nearest[slot].is_exact()) {
    clearance = surfaces_.clearance(before, at.world, clearance);
    keep(slot, clearance, NearestSurface(before));
  }
  if (at.to_sphere >= clearance || bounds.lower >= clearance) {
    return;
  }
  if (bounds.upper < clearance) {
    keep(slot, bounds.upper, newcomer_.nearest(id_, bounds));
    return;
  }
  const float distance = newcomer_.placed().distance(at.unit, clearance);
  if (distance < clearance) {
    keep(slot, distance, NearestSurface(id_));
  }
}

}  // namespace

BlockRange footprint(const VoxelGrid& grid, const Hole& hole) {
  const auto block_of = [&](const dvec3& point) {
    const dvec3 voxel = glm::floor((point - grid.origin) / grid.voxel_side);
    return glm::clamp(voxel, dvec3(0.0), dvec3(grid.size - 1));
  };
  const double reach = 2.0 * hole.clearance;
  return {glm::ivec3(block_of(hole.center - reach)) / VoxelGrid::block_side,
          glm::ivec3(block_of(hole.center + reach)) / VoxelGrid::block_side + 1};
}

void update(ClearanceField& field, const Surfaces& surfaces, SurfaceId id, const Hole& hole,
            float useless, Update& done) {
  const VoxelGrid& grid = field.grid();
  const PlacedElement placed = surfaces.placed(surfaces.instances[id - 1]);
  const Newcomer newcomer(placed, grid);
  done.voxels_flagged = 0;
  done.before.clear();
  done.maxima.clear();

  const BlockRange range = footprint(grid, hole);
  const double block_side = VoxelGrid::block_side * grid.voxel_side;
  glm::ivec3 at;
  for (at.z = range.first.z; at.z < range.last.z; ++at.z) {
    for (at.y = range.first.y; at.y < range.last.y; ++at.y) {
      for (at.x = range.first.x; at.x < range.last.x; ++at.x) {
        const std::size_t index = grid.block_index(at);
        const float maximum = field.block_maximum(index);
        if (maximum < 0.0F) {
          continue;
        }
        const dvec3 corner = grid.origin + dvec3(at) * block_side;
        const double reach = placed.radius() + (maximum < useless ? 0.0F : maximum);
        if (squared_distance({corner, corner + block_side}, placed.center()) < reach * reach) {
          done.maxima.push_back({index, maximum});
        }
      }
    }
  }
  BlockUpdate work(field, surfaces, id, newcomer, useless);
  if (done.maxima.size() <= blocks_on_one_thread) {
    for (Update::Maximum& maximum : done.maxima) {
      done.voxels_flagged += work.run(maximum.block, done.before);
      maximum.upper = field.scan_block(maximum.block);
    }
    return;
  }
  std::vector<std::size_t> flagged(done.maxima.size());
  std::vector<std::vector<Update::Voxel>> before(done.maxima.size());
  tbb::parallel_for(std::size_t{0}, done.maxima.size(), [&](std::size_t b) {
    BlockUpdate mine = work;
    flagged[b] = mine.run(done.maxima[b].block, before[b]);
    done.maxima[b].upper = field.scan_block(done.maxima[b].block);
  });
  for (std::size_t b = 0; b < flagged.size(); ++b) {
    done.voxels_flagged += flagged[b];
    done.before.insert(done.before.end(), before[b].begin(), before[b].end());
  }
}

void commit(ClearanceField& field, const Update& done) {
  for (const Update::Maximum& maximum : done.maxima) {
    field.set_block_maximum(maximum.block, maximum.upper);
  }
}

void undo(ClearanceField& field, const Update& done) {
  for (auto voxel = done.before.rbegin(); voxel != done.before.rend(); ++voxel) {
    const ClearanceField::Block block = field.block(voxel->block);
    block.upper[voxel->slot] = voxel->upper;
    block.nearest[voxel->slot] = voxel->nearest;
  }
}

float make_exact(ClearanceField& field, const Surfaces& surfaces, const ClearanceField::Peak& peak,
                 float useless) {
  const ClearanceField::Block block = field.block(peak.block);
  NearestSurface& nearest = block.nearest[peak.slot];
  float& upper = block.upper[peak.slot];
  const dvec3 point = field.sample_point(peak);
  if (upper < useless) {
    const auto [id, clearance] = surfaces.nearest(point);
    nearest = NearestSurface(id);
    upper = clearance;
  } else if (!nearest.is_exact()) {
    upper = surfaces.clearance(nearest.id(), point, upper);
    nearest = NearestSurface(nearest.id());
  }
  return field.scan_block(peak.block);
}

}  // namespace collage
