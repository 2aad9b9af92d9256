#pragma once

#include <cstdint>
#include <vector>

#include "base/status.h"
#include "packing/target.h"
#include "packing/voxel_grid.h"

namespace collage {

/// Which surface is nearest to a voxel: the target's or that of instance `id - 1`.
using SurfaceId = std::uint32_t;
inline constexpr SurfaceId target_surface = 0;

/// A point where an element may be centred. `clearance` ≤ 0: there is no hole left.
struct Hole {
  glm::dvec3 center{0.0};
  double clearance = -1.0;
  SurfaceId nearest = target_surface;
};

/// The thesis's signed distance function (Muhm 2011, III.2): for each voxel's sample point the
/// distance to the nearest surface, never more than the true one, and whose surface that is;
/// negative (and of no particular size) outside the target and inside instances.
/// Memory: 8 bytes a voxel.
class ClearanceField {
 public:
  /// One block of 8³ voxels, open to change by one thread at a time.
  struct Block {
    glm::ivec3 first_voxel;
    float* clearance;
    SurfaceId* nearest;
  };

  /// Samples the target on all threads. Throws Error where the voxels would not fit in memory.
  ClearanceField(const Target& target, const VoxelGrid& grid, Status& status);

  [[nodiscard]] const VoxelGrid& grid() const { return grid_; }
  /// Number of sample points inside the target.
  [[nodiscard]] std::size_t voxels_inside() const { return voxels_inside_; }

  /// Ties go to the voxel stored first. O(1).
  [[nodiscard]] Hole largest_hole() const;

  [[nodiscard]] Block block(std::size_t index);
  [[nodiscard]] float block_maximum(std::size_t index) const { return maxima_[leaves_ + index]; }
  /// To be called for each block after clearances in it have changed. O(log n).
  void set_block_maximum(std::size_t index, float maximum);
  /// The largest clearance in the block, from its voxels.
  [[nodiscard]] float scan_block(std::size_t index) const;

 private:
  void sample(const Target& target, std::size_t block_index);

  VoxelGrid grid_;
  std::vector<float> clearance_;
  std::vector<SurfaceId> nearest_;
  /// A tournament: a node at i is the larger of those at 2i and 2i + 1; the blocks' maxima stand at
  /// leaves_ and on.
  std::vector<float> maxima_;
  std::size_t leaves_ = 1;
  std::size_t voxels_inside_ = 0;
};

}  // namespace collage
