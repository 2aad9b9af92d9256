#pragma once

#include <cstdint>
#include <vector>

#include "base/status.h"
#include "fitting/distance_field.h"
#include "fitting/pose.h"
#include "fitting/shaped_element.h"
#include "packing/target.h"

namespace collage {

/// What is still free: signed distances to the nearest surface of target or instances, on a lattice
/// over the target, and for each block of it the largest distance and the instances near it. In
/// world units. Memory: 8 bytes a lattice point.
class FreeSpace {
 public:
  /// Samples the target on all threads. Throws Error where the points would not fit in memory,
  /// Interrupted where the user stops it.
  FreeSpace(const Target& target, int resolution, Status& status);

  [[nodiscard]] const DistanceField& distances() const { return distances_; }
  /// Before anything was added.
  [[nodiscard]] const DistanceField& target_distances() const { return target_distances_; }
  [[nodiscard]] std::size_t points_inside_target() const { return points_inside_target_; }
  [[nodiscard]] std::size_t points_inside_instances() const { return points_inside_instances_; }
  [[nodiscard]] float largest_distance() const { return largest_; }

  /// A local maximum of the distance over the 26 neighbours.
  struct Peak {
    dvec3 position;
    float distance;
  };
  /// All of at least `least`, the highest first. Runs on all threads.
  [[nodiscard]] std::vector<Peak> peaks(float least) const;
  /// Those in blocks that the latest add() has changed, or next to one.
  [[nodiscard]] std::vector<Peak> changed_peaks(float least) const;
  /// The peak that steepest ascent over neighbours leads to.
  [[nodiscard]] Peak climb(const dvec3& from) const;

  /// Accounts for a new instance. Only blocks that it can change are looked at: distances change by
  /// no more than the way one goes. Runs on all threads; the result does not depend on their
  /// number.
  void add(const ShapedElement& shape, const Pose& pose, std::uint32_t instance);

  /// Calls `visit(instance)` for all instances added, from number `first` on, that come within
  /// `reach` of `center`, some others, and some more than once.
  template <class Visit>
  void visit_near(const dvec3& center, double reach, std::uint32_t first, Visit&& visit) const {
    for_blocks_near(center, reach, [&](std::size_t block) {
      const std::vector<std::uint32_t>& residents = residents_[block];
      for (auto last = residents.rbegin(); last != residents.rend() && *last >= first; ++last) {
        visit(*last);
      }
    });
  }

 private:
  static constexpr int block_side = 8;

  [[nodiscard]] std::size_t block_index(const glm::ivec3& block) const {
    return (static_cast<std::size_t>(block.z) * blocks_.y + block.y) * blocks_.x + block.x;
  }
  [[nodiscard]] glm::ivec3 block_at(std::size_t index) const {
    const int i = static_cast<int>(index);
    return {i % blocks_.x, i / blocks_.x % blocks_.y, i / (blocks_.x * blocks_.y)};
  }
  template <class Visit>
  void for_blocks_near(const dvec3& center, double reach, Visit&& visit) const {
    const dvec3 last(blocks_ - 1);
    const dvec3 low = distances_.steps(center - reach) / double{block_side};
    const dvec3 high = distances_.steps(center + reach) / double{block_side};
    const glm::ivec3 from(glm::clamp(glm::floor(low), dvec3(0.0), last));
    const glm::ivec3 to(glm::clamp(glm::floor(high), dvec3(0.0), last));
    for (int z = from.z; z <= to.z; ++z) {
      for (int y = from.y; y <= to.y; ++y) {
        for (int x = from.x; x <= to.x; ++x) {
          visit(block_index({x, y, z}));
        }
      }
    }
  }
  void scan_maximum(std::size_t block);
  void find_largest();
  void append_peaks(std::size_t block, float least, std::vector<Peak>& found) const;
  [[nodiscard]] bool is_peak(const glm::ivec3& p) const;
  [[nodiscard]] std::vector<Peak> peaks_of(const std::vector<std::size_t>& blocks,
                                           float least) const;
  [[nodiscard]] std::vector<std::size_t> with_neighbours(std::vector<std::size_t> blocks) const;

  class Newcomer;
  /// What add() did to a block.
  struct Change {
    bool changed = false;
    std::size_t filled = 0;
  };
  void list_resident(const Newcomer& newcomer, const Pose& pose, std::uint32_t instance);
  Change add_to_block(std::size_t block, const Newcomer& newcomer);

  DistanceField distances_;
  DistanceField target_distances_;
  glm::ivec3 blocks_{0};
  std::vector<float> maxima_;
  /// By block, rising.
  std::vector<std::vector<std::uint32_t>> residents_;
  std::vector<std::size_t> changed_;
  float largest_ = -1.0F;
  std::size_t points_inside_target_ = 0;
  std::size_t points_inside_instances_ = 0;
};

}  // namespace collage
