#pragma once

#include <array>
#include <vector>

#include "packing/clearance_field.h"
#include "packing/surfaces.h"
#include "packing/update.h"

namespace collage {

/// Accounts for an instance in the voxels of one block after the other, as update() has it; four
/// voxels at a time, in float, and in double only where the element's surface is so near that float
/// cannot tell inside from outside.
class BlockUpdate {
 public:
  BlockUpdate(ClearanceField& field, SurfaceId id, const PlacedElement& placed, float useless);

  /// Returns the number of voxels flagged.
  std::size_t run(Update::Maximum& result, std::vector<Update::Voxel>& before);

 private:
  using Slots = std::array<std::uint32_t, VoxelGrid::block_voxels + four_lanes>;

  [[nodiscard]] std::size_t slots_in_reach(Slots& slots) const;
  [[nodiscard]] Points<Four> unit_points(const std::uint32_t* slots) const;
  [[nodiscard]] bool holds(std::uint32_t slot, const Points<Four>& units, std::size_t lane) const;
  void visit(const std::uint32_t* slots, std::size_t count);
  void set_distance(std::uint32_t slot, float lower, float upper);
  void record(std::uint32_t slot) {
    before_[changed_++] = {static_cast<std::uint32_t>(index_), slot, block_.upper[slot],
                           block_.nearest[slot]};
  }
  void keep(std::uint32_t slot, SurfaceId nearest, float lower, float upper) {
    record(slot);
    block_.upper[slot] = upper;
    const float gap_voxels = (upper - lower) / voxel_side_ * PlacedElement::above_one;
    block_.nearest[slot] = {nearest, gap_voxels};
  }

  ClearanceField& field_;
  SurfaceId id_;
  const PlacedElement& placed_;
  float useless_;
  float voxel_side_;
  /// Of the bounding sphere, and as much more as a voxel's centre is off its sample point.
  float radius_;
  /// How far a point of unit_points() may be off, other than by a share of its length.
  float off_;
  /// A voxel's sides in the unit frame.
  std::array<Points<Four>, 3> unit_sides_;

  std::size_t index_ = 0;
  ClearanceField::Block block_{};
  /// From the element's centre to that of the first voxel.
  dvec3 first_{0.0};
  std::array<Update::Voxel, VoxelGrid::block_voxels> before_{};
  std::size_t changed_ = 0;
  std::size_t flagged_ = 0;
  bool is_near_ = false;
};

}  // namespace collage
