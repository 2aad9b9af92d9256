#pragma once

#include <array>
#include <optional>
#include <vector>

#include "base/status.h"
#include "packing/nearest_surface.h"
#include "packing/target.h"
#include "packing/voxel_grid.h"

namespace collage {

/// A point where an element may be centred. `clearance` ≤ 0: there is no hole left.
struct Hole {
  glm::dvec3 center{0.0};
  double clearance = -1.0;
  SurfaceId nearest = target_surface;
};

/// The thesis's signed distance function (Muhm 2011, III.2): for each voxel's sample point the
/// distance to the nearest surface, never more than the true one, and whose surface that is;
/// negative (and of no particular size) outside the target and inside instances.
///
/// A clearance is known between two bounds, which meet where it is exact: it is asked exactly only
/// where that decides, as it does for a hole to be filled. Memory: 8 bytes a voxel, 16 a block, and
/// 8 for each block that an instance comes near to.
class ClearanceField {
 public:
  /// One block of voxels, open to change by one thread at a time.
  struct Block {
    glm::ivec3 first_voxel;
    /// No clearance is above this; negative where there is none.
    float* upper;
    NearestSurface* nearest;
  };
  /// A voxel whose upper bound is the largest.
  struct Peak {
    std::size_t block;
    std::size_t slot;
    float upper;
  };

  /// Samples the target on all threads. Throws Error where the voxels would not fit in memory.
  ClearanceField(const Target& target, const VoxelGrid& grid, Status& status);

  [[nodiscard]] const VoxelGrid& grid() const { return grid_; }
  /// Number of sample points inside the target.
  [[nodiscard]] std::size_t voxels_inside() const { return voxels_inside_; }

  /// Nothing where no voxel has space left. Ties go to the first group of blocks, and in it to the
  /// voxel of the least z, then y, then x. O(log n).
  [[nodiscard]] std::optional<Peak> peak() const;

  [[nodiscard]] Block block(std::size_t index);
  [[nodiscard]] dvec3 sample_point(const Peak& peak) const;
  [[nodiscard]] float block_maximum(std::size_t index) const { return maxima_[leaves_ + index]; }
  /// To be called for each block after clearances in it have changed. O(log n).
  void set_block_maximum(std::size_t index, float maximum);
  /// No voxel of the block that is inside the target is nearer to its surface.
  [[nodiscard]] float least_from_target(std::size_t block) const {
    return least_from_target_[block];
  }
  /// Notes that instance `id` may be the nearest surface to voxels of a block.
  void add_neighbour(std::size_t block, SurfaceId id);
  /// Calls `visit(id)` for each such instance.
  template <class Visit>
  void for_each_neighbour(std::size_t block, const Visit& visit) const {
    for (std::uint32_t list = last_neighbours_[block]; list != 0; list = neighbours_[list].before) {
      for (const SurfaceId id : neighbours_[list].ids) {
        if (id == target_surface) {
          break;
        }
        visit(id);
      }
    }
  }
  /// Gives up a hole: its voxel has no clearance from now on.
  void close(const Peak& peak);
  /// The largest upper bound in the block, from its voxels.
  [[nodiscard]] float scan_block(std::size_t index) const;

 private:
  void sample(const Target& target, std::size_t group);

  VoxelGrid grid_;
  std::vector<float> upper_;
  std::vector<NearestSurface> nearest_;
  /// A tournament: a node at i is the larger of those at 2i and 2i + 1; the blocks' maxima stand at
  /// leaves_ and on.
  std::vector<float> maxima_;
  std::size_t leaves_ = 1;
  std::vector<float> least_from_target_;
  std::size_t voxels_inside_ = 0;

  /// Some of a block's; as large as what the processor fetches at a time.
  struct Neighbours {
    /// Filled from the front; the rest is `target_surface`.
    std::array<SurfaceId, 15> ids{};
    /// Index of those that came before; 0: none.
    std::uint32_t before = 0;
  };
  std::vector<Neighbours> neighbours_{1};
  std::vector<std::uint32_t> last_neighbours_;
};

}  // namespace collage
