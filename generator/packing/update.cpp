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

/// A footprint of more blocks than this is worth being shared among threads.
constexpr std::size_t blocks_on_one_thread = 64;

/// Updates the voxels of one block.
class BlockUpdate {
 public:
  BlockUpdate(ClearanceField& field, SurfaceId id, const PlacedElement& placed, float useless)
      : field_(field),
        id_(id),
        placed_(placed),
        useless_(useless),
        voxel_side_(static_cast<float>(field.grid().voxel_side)) {}

  /// Returns the number of voxels flagged.
  std::size_t run(Update::Maximum& result, std::vector<Update::Voxel>& before);

 private:
  void visit(std::size_t slot);
  void set_distance(std::size_t slot, const dvec3& unit);
  void record(std::size_t slot) {
    before_->push_back({index_, slot, block_.upper[slot], block_.nearest[slot]});
  }
  void keep(std::size_t slot, SurfaceId nearest, const PlacedElement::Bounds& bounds) {
    record(slot);
    block_.upper[slot] = bounds.upper;
    const float gap_voxels = (bounds.upper - bounds.lower) / voxel_side_ * PlacedElement::above_one;
    block_.nearest[slot] = {nearest, gap_voxels};
  }

  ClearanceField& field_;
  SurfaceId id_;
  const PlacedElement& placed_;
  float useless_;
  float voxel_side_;

  std::size_t index_ = 0;
  ClearanceField::Block block_{};
  std::vector<Update::Voxel>* before_ = nullptr;
  std::size_t flagged_ = 0;
  bool is_near_ = false;
};

std::size_t BlockUpdate::run(Update::Maximum& result, std::vector<Update::Voxel>& before) {
  index_ = result.block;
  block_ = field_.block(index_);
  before_ = &before;
  flagged_ = 0;
  is_near_ = false;
  const VoxelGrid& grid = field_.grid();
  // From the voxels' centres, which are so near to the sample points.
  const double off_center = (0.5 * std::sqrt(3.0) * grid.jitter + 1e-4) * grid.voxel_side;
  const auto radius = static_cast<float>(placed_.radius() * (1.0 + 1e-5) + off_center);
  const float maximum = field_.block_maximum(index_);
  const float reach = radius + (maximum < useless_ ? 0.0F : maximum);
  const dvec3 first_center = grid.origin + (dvec3(block_.first_voxel) + 0.5) * grid.voxel_side;
  const glm::vec3 first(first_center - placed_.center());
  const auto side = static_cast<float>(grid.voxel_side);
  std::array<float, VoxelGrid::block_side> squared_x;
  for (int x = 0; x < VoxelGrid::block_side; ++x) {
    const float away = first.x + static_cast<float>(x) * side;
    squared_x[static_cast<std::size_t>(x)] = away * away;
  }
  for (int yz = 0; yz < VoxelGrid::block_side * VoxelGrid::block_side; ++yz) {
    const int layer = yz / VoxelGrid::block_side;
    const float y = first.y + static_cast<float>(yz % VoxelGrid::block_side) * side;
    const float z = first.z + static_cast<float>(layer) * side;
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
  result.upper = field_.scan_block(index_);
  result.is_near |= is_near_;
  return flagged_;
}

void BlockUpdate::visit(std::size_t slot) {
  const dvec3 point = field_.grid().sample_point(block_.first_voxel + VoxelGrid::local_at(slot));
  if (placed_.distance_to_sphere(point) >= block_.upper[slot]) {
    return;
  }
  const dvec3 unit = placed_.unit_from_world(point);
  if (placed_.holds(unit)) {
    record(slot);
    block_.upper[slot] = -1.0F;
    ++flagged_;
    return;
  }
  if (block_.upper[slot] >= useless_) {
    set_distance(slot, unit);
  }
}

void BlockUpdate::set_distance(std::size_t slot, const dvec3& unit) {
  const float upper = block_.upper[slot];
  const auto bounds = placed_.bounds(unit, upper);

  if (!bounds) {
    return;
  }
  const float lower = block_.nearest[slot].lower(upper, voxel_side_);
  if (bounds->upper < std::max(lower, useless_)) {
    keep(slot, id_, *bounds);
  } else {
    keep(slot, several_surfaces, {std::min(lower, bounds->lower), std::min(upper, bounds->upper)});
  }
  is_near_ = true;
}

}  // namespace

BlockRange footprint(const VoxelGrid& grid, const Hole& hole, double margin) {
  const auto block_of = [&](const dvec3& point) {
    const dvec3 voxel = glm::floor((point - grid.origin) / grid.voxel_side);
    return glm::clamp(voxel, dvec3(0.0), dvec3(grid.size - 1));
  };
  const double reach = 2.0 * hole.clearance + margin;
  return {glm::ivec3(block_of(hole.center - reach)) / VoxelGrid::block_side,
          glm::ivec3(block_of(hole.center + reach)) / VoxelGrid::block_side + 1};
}

void update(ClearanceField& field, const Surfaces& surfaces, SurfaceId id, const Hole& hole,
            float useless, double margin, Update& done) {
  const VoxelGrid& grid = field.grid();
  const PlacedElement placed = surfaces.placed(id, grid.voxel_side);
  done.id = id;
  done.voxels_flagged = 0;
  done.before.clear();
  done.maxima.clear();

  const BlockRange range = footprint(grid, hole, margin);
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
        const bool has_holes = maximum >= useless;
        const double reach = placed.radius() * (1.0 + 1e-5) + (has_holes ? maximum + margin : 0.0);
        if (squared_distance({corner, corner + block_side}, placed.center()) < reach * reach) {
          done.maxima.push_back({index, maximum, has_holes && margin > 0.0});
        }
      }
    }
  }
  BlockUpdate work(field, id, placed, useless);
  if (done.maxima.size() <= blocks_on_one_thread) {
    for (Update::Maximum& maximum : done.maxima) {
      done.voxels_flagged += work.run(maximum, done.before);
    }
    return;
  }
  const std::size_t blocks = done.maxima.size();
  done.shares.resize(std::max(done.shares.size(), blocks));
  tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t b) {
    BlockUpdate mine = work;
    Update::Share& share = done.shares[b];
    share.before.clear();
    share.voxels_flagged = mine.run(done.maxima[b], share.before);
  });
  for (std::size_t b = 0; b < blocks; ++b) {
    const Update::Share& share = done.shares[b];
    done.voxels_flagged += share.voxels_flagged;
    done.before.insert(done.before.end(), share.before.begin(), share.before.end());
  }
}

void commit(ClearanceField& field, const Update& done) {
  for (const Update::Maximum& maximum : done.maxima) {
    field.set_block_maximum(maximum.block, maximum.upper);
    if (maximum.is_near) {
      field.add_neighbour(maximum.block, done.id);
    }
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
  if (upper >= useless && nearest.is_exact()) {
    return field.scan_block(peak.block);
  }
  const dvec3 point = field.sample_point(peak);
  Nearest found;
  const auto consider = [&](SurfaceId id) { surfaces.consider(id, point, found); };
  if (upper < useless) {
    consider(target_surface);
    for (std::size_t i = 1; i <= surfaces.instances.size(); ++i) {
      consider(static_cast<SurfaceId>(i));
    }
  } else if (nearest.id() == several_surfaces) {
    found.clearance = upper;
    field.for_each_neighbour(peak.block, consider);
    if (field.least_from_target(peak.block) <= found.clearance) {
      consider(target_surface);
    }
  } else {
    found.clearance = upper;
    consider(nearest.id());
  }
  nearest = NearestSurface(found.id);
  upper = found.clearance;
  return field.scan_block(peak.block);
}

}  // namespace collage
