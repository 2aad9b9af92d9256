#include "packing/block_update.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace collage {

BlockUpdate::BlockUpdate(ClearanceField& field, SurfaceId id, const PlacedElement& placed,
                         float useless)
    : field_(field),
      id_(id),
      placed_(placed),
      useless_(useless),
      voxel_side_(static_cast<float>(field.grid().voxel_side)) {
  const VoxelGrid& grid = field.grid();
  for (int axis = 0; axis < 3; ++axis) {
    unit_sides_[static_cast<std::size_t>(axis)] =
        all_four(glm::vec3(placed.unit_from_world()[axis] * grid.voxel_side));
  }
  const double off_center = (0.5 * std::sqrt(3.0) * grid.jitter + 1e-4) * grid.voxel_side;
  radius_ = static_cast<float>(placed.radius() * (1.0 + 1e-5) + off_center);
  // A hundred roundings to float of a voxel's side, and some to double of the place in the world.
  const dvec3 place = glm::abs(placed.center()) + glm::abs(grid.origin);
  off_ = static_cast<float>(
      (6e-6 * grid.voxel_side + 1e-15 * std::max({place.x, place.y, place.z})) / placed.radius());
}

std::size_t BlockUpdate::run(Update::Maximum& result, std::vector<Update::Voxel>& before) {
  index_ = result.block;
  block_ = field_.block(index_);
  const VoxelGrid& grid = field_.grid();
  first_ = grid.origin + (dvec3(block_.first_voxel) + 0.5) * grid.voxel_side - placed_.center();
  changed_ = 0;
  flagged_ = 0;
  is_near_ = false;
  Slots slots;
  const std::size_t count = slots_in_reach(slots);
  for (std::size_t i = 0; i < count; i += four_lanes) {
    visit(&slots[i], std::min(count - i, four_lanes));
  }
  before.insert(before.end(), before_.begin(),
                before_.begin() + static_cast<std::ptrdiff_t>(changed_));
  result.upper = field_.scan_block(index_);
  result.is_near |= is_near_;
  return flagged_;
}

/// The voxels that may change, and after them three more to fill the last four; returns how many
/// may change.
std::size_t BlockUpdate::slots_in_reach(Slots& slots) const {
  const glm::vec3 first(first_);
  const Four x = first.x + Four{0.0F, 1.0F, 2.0F, 3.0F} * voxel_side_;
  const Four squared_x = x * x;
  std::size_t count = 0;
  for (std::uint32_t slot = 0; slot < VoxelGrid::block_voxels; slot += four_lanes) {
    const glm::vec3 yz = first + glm::vec3(VoxelGrid::local_at(slot)) * voxel_side_;
    Four upper;
    std::memcpy(&upper, block_.upper + slot, sizeof upper);
    const Four near = radius_ + (upper < useless_ ? Four{} : upper);
    const FourIntegers in_reach =
        (upper >= 0.0F) & (squared_x + (yz.y * yz.y + yz.z * yz.z) < near * near);
    for (std::uint32_t lane = 0; lane < four_lanes; ++lane) {
      slots[count] = slot + lane;
      count -= static_cast<std::size_t>(std::ptrdiff_t{in_reach[lane]});
    }
  }
  std::fill_n(slots.begin() + static_cast<std::ptrdiff_t>(count), four_lanes - 1, 0);
  return count;
}

Points<Four> BlockUpdate::unit_points(const std::uint32_t* slots) const {
  const VoxelGrid& grid = field_.grid();
  const auto jitter = static_cast<float>(grid.jitter);
  Points<Four> units = all_four(glm::vec3(placed_.unit_from_world() * first_));
  const auto local = [&](std::size_t lane) { return VoxelGrid::local_at(slots[lane]); };
  const auto draw = [&](std::size_t lane) { return grid.draw(block_.first_voxel + local(lane)); };
  const std::array drawn{draw(0), draw(1), draw(2), draw(3)};
  for (int axis = 0; axis < 3; ++axis) {
    const FourIntegers numbers{drawn[0][axis], drawn[1][axis], drawn[2][axis], drawn[3][axis]};
    const FourIntegers sides{local(0)[axis], local(1)[axis], local(2)[axis], local(3)[axis]};
    const Four in_voxel = __builtin_convertvector(numbers, Four) * 0x1p-21F - 0.5F;
    const Four along = __builtin_convertvector(sides, Four) + jitter * in_voxel;
    for (std::size_t k = 0; k < 3; ++k) {
      units[k] += unit_sides_[static_cast<std::size_t>(axis)][k] * along;
    }
  }
  return units;
}

/// Exactly PlacedElement::holds().
bool BlockUpdate::holds(std::uint32_t slot, const Points<Four>& units, std::size_t lane) const {
  const glm::vec3 unit(units[0][lane], units[1][lane], units[2][lane]);
  const float squared = glm::dot(unit, unit);
  if (off_ < Solid::cell_margin / 2) {
    if (squared > 1.0F + 4.0F * static_cast<float>(Solid::cell_margin)) {
      return false;
    }
    if (squared < 1.0F - 4.0F * static_cast<float>(Solid::cell_margin)) {
      if (const auto inside = placed_.element().solid().inside_by_cell(unit)) {
        return *inside;
      }
    }
  }
  const dvec3 point = field_.grid().sample_point(block_.first_voxel + VoxelGrid::local_at(slot));
  return placed_.holds(placed_.unit_from_world(point));
}

void BlockUpdate::visit(const std::uint32_t* slots, std::size_t count) {
  const Points<Four> units = unit_points(slots);
  const PlacedElement::Bounds bounds = placed_.bounds(units, off_);
  for (std::size_t lane = 0; lane < count; ++lane) {
    const std::uint32_t slot = slots[lane];
    if (holds(slot, units, lane)) {
      record(slot);
      block_.upper[slot] = -1.0F;
      ++flagged_;
    } else if (block_.upper[slot] >= useless_ && bounds.lower[lane] < block_.upper[slot]) {
      set_distance(slot, bounds.lower[lane], bounds.upper[lane]);
    }
  }
}

void BlockUpdate::set_distance(std::uint32_t slot, float lower, float upper) {
  const float upper_before = block_.upper[slot];
  const float lower_before = block_.nearest[slot].lower(upper_before, voxel_side_);
  if (upper < std::max(lower_before, useless_)) {
    keep(slot, id_, lower, upper);
  } else {
    keep(slot, several_surfaces, std::min(lower_before, lower), std::min(upper_before, upper));
  }
  is_near_ = true;
}

}  // namespace collage
