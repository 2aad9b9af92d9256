#include "fitting/free_space.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include "base/error.h"
#include "base/memory.h"

namespace collage {

/// The new instance, seen from the lattice.
class FreeSpace::Newcomer {
 public:
  Newcomer(const ShapedElement& shape, const Pose& pose)
      : shape_(shape),
        pose_(pose),
        unit_from_world_(glm::transpose(glm::mat3_cast(pose.rotation)) * (1.0 / pose.radius)) {}

  /// No more than the distance to the instance, but for the error of its lattice.
  [[nodiscard]] double least_distance(const dvec3& point) const {
    const dvec3 steps = shape_.distances().steps(unit(point));
    return shape_.distances().holds(steps) ? shape_.distances().value(steps) * pose_.radius
                                           : to_ball(point);
  }
  [[nodiscard]] double lattice_error() const {
    return std::sqrt(3.0) * shape_.distances().spacing() * pose_.radius;
  }
  /// The distance to the instance where it is below `limit`, else no less than `limit`.
  [[nodiscard]] double distance(const dvec3& point, double limit) const {
    const double ball = to_ball(point);
    if (ball >= limit) {
      return limit;
    }
    const dvec3 at = unit(point);
    const dvec3 steps = shape_.distances().steps(at);
    if (shape_.distances().holds(steps)) {
      return shape_.distances().value(steps) * pose_.radius;
    }
    const auto closest = shape_.element().solid().surface().find(at, limit / pose_.radius);
    return closest ? closest->distance * pose_.radius : limit;
  }

 private:
  [[nodiscard]] dvec3 unit(const dvec3& point) const {
    return unit_from_world_ * (point - pose_.center);
  }
  [[nodiscard]] double to_ball(const dvec3& point) const {
    return glm::distance(point, pose_.center) - pose_.radius;
  }

  const ShapedElement& shape_;
  const Pose& pose_;
  glm::dmat3 unit_from_world_;
};

FreeSpace::FreeSpace(const Target& target, int resolution, Status& status) {
  const VoxelGrid grid = target.voxels(resolution, 0.0, 0);
  const auto count = static_cast<std::size_t>(grid.size.x) * grid.size.y * grid.size.z;
  require_memory(2 * count * sizeof(float), "the voxels", "target.resolution");
  distances_ = DistanceField(grid.sample_point({0, 0, 0}), grid.voxel_side, grid.size);
  for (int z = 0; z < grid.size.z; ++z) {
    if (status.stop_requested()) {
      throw Interrupted();
    }
    tbb::parallel_for(0, grid.size.y, [&](int y) {
      for (int x = 0; x < grid.size.x; ++x) {
        const glm::ivec3 p(x, y, z);
        distances_.at(p) = static_cast<float>(target.signed_clearance(distances_.point(p)));
      }
    });
    status.update(static_cast<double>(z + 1) / grid.size.z, "distances");
  }
  distances_.close_gaps();
  target_distances_ = distances_;
  points_inside_target_ = static_cast<std::size_t>(
      std::ranges::count_if(distances_.values(), [](float d) { return d > 0.0F; }));

  blocks_ = (grid.size + (block_side - 1)) / block_side;
  maxima_.resize(static_cast<std::size_t>(blocks_.x) * blocks_.y * blocks_.z);
  residents_.resize(maxima_.size());
  for (std::size_t block = 0; block < maxima_.size(); ++block) {
    scan_maximum(block);
  }
  find_largest();
}

void FreeSpace::scan_maximum(std::size_t block) {
  const glm::ivec3 from = block_at(block) * block_side;
  const glm::ivec3 to = glm::min(from + block_side, distances_.size());
  float maximum = distances_.at(from);
  for (int z = from.z; z < to.z; ++z) {
    for (int y = from.y; y < to.y; ++y) {
      const float* row = &distances_.values()[distances_.index({from.x, y, z})];
      maximum = std::max(maximum, *std::max_element(row, row + (to.x - from.x)));
    }
  }
  maxima_[block] = maximum;
}

void FreeSpace::find_largest() { largest_ = *std::ranges::max_element(maxima_); }

bool FreeSpace::is_peak(const glm::ivec3& p) const {
  const std::size_t here = distances_.index(p);
  const float distance = distances_.values()[here];
  for (int z = -1; z <= 1; ++z) {
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        const std::size_t there = distances_.index(p + glm::ivec3(x, y, z));
        const float other = distances_.values()[there];
        if (other > distance || (other == distance && there < here)) {
          return false;
        }
      }
    }
  }
  return true;
}

void FreeSpace::append_peaks(std::size_t block, float least, std::vector<Peak>& found) const {
  if (maxima_[block] < least) {
    return;
  }
  const glm::ivec3 from = glm::max(block_at(block) * block_side, glm::ivec3(1));
  const glm::ivec3 to = glm::min(block_at(block) * block_side + block_side, distances_.size() - 1);
  for (int z = from.z; z < to.z; ++z) {
    for (int y = from.y; y < to.y; ++y) {
      for (int x = from.x; x < to.x; ++x) {
        const glm::ivec3 p(x, y, z);
        if (distances_.at(p) >= least && is_peak(p)) {
          found.push_back({distances_.point(p), distances_.at(p)});
        }
      }
    }
  }
}

std::vector<FreeSpace::Peak> FreeSpace::peaks_of(const std::vector<std::size_t>& blocks,
                                                 float least) const {
  std::vector<std::vector<Peak>> found(blocks.size());
  tbb::parallel_for(std::size_t{0}, blocks.size(),
                    [&](std::size_t b) { append_peaks(blocks[b], least, found[b]); });
  std::vector<Peak> all;
  for (const std::vector<Peak>& some : found) {
    all.insert(all.end(), some.begin(), some.end());
  }
  std::ranges::stable_sort(all, std::ranges::greater{}, &Peak::distance);
  return all;
}

std::vector<FreeSpace::Peak> FreeSpace::peaks(float least) const {
  std::vector<std::size_t> all(maxima_.size());
  for (std::size_t block = 0; block < all.size(); ++block) {
    all[block] = block;
  }
  return peaks_of(all, least);
}

std::vector<FreeSpace::Peak> FreeSpace::changed_peaks(float least) const {
  return peaks_of(with_neighbours(changed_), least);
}

std::vector<std::size_t> FreeSpace::with_neighbours(std::vector<std::size_t> blocks) const {
  const std::size_t own = blocks.size();
  for (std::size_t b = 0; b < own; ++b) {
    const glm::ivec3 at = block_at(blocks[b]);
    const glm::ivec3 from = glm::max(at - 1, glm::ivec3(0));
    const glm::ivec3 to = glm::min(at + 1, blocks_ - 1);
    for (int z = from.z; z <= to.z; ++z) {
      for (int y = from.y; y <= to.y; ++y) {
        for (int x = from.x; x <= to.x; ++x) {
          blocks.push_back(block_index({x, y, z}));
        }
      }
    }
  }
  std::ranges::sort(blocks);
  blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
  return blocks;
}

FreeSpace::Peak FreeSpace::climb(const dvec3& from) const {
  constexpr int most_steps = 40;
  const glm::ivec3 last = distances_.size() - 2;
  glm::ivec3 at = glm::clamp(glm::ivec3(glm::round(distances_.steps(from))), glm::ivec3(1), last);
  for (int step = 0; step < most_steps; ++step) {
    glm::ivec3 best = at;
    for (int i = 0; i < 27; ++i) {
      const glm::ivec3 next =
          glm::clamp(at + glm::ivec3(i % 3, i / 3 % 3, i / 9) - 1, glm::ivec3(1), last);
      if (distances_.at(next) > distances_.at(best)) {
        best = next;
      }
    }
    if (best == at) {
      break;
    }
    at = best;
  }
  return {distances_.point(at), distances_.at(at)};
}

FreeSpace::Change FreeSpace::add_to_block(std::size_t block, const Newcomer& newcomer) {
  const glm::ivec3 from = block_at(block) * block_side;
  const glm::ivec3 to = glm::min(from + block_side, distances_.size());
  Change change;
  for (int z = from.z; z < to.z; ++z) {
    for (int y = from.y; y < to.y; ++y) {
      for (int x = from.x; x < to.x; ++x) {
        float& here = distances_.at({x, y, z});
        const auto nearer =
            static_cast<float>(newcomer.distance(distances_.point({x, y, z}), here));
        if (nearer < here) {
          change.filled += here > 0.0F && nearer <= 0.0F ? 1 : 0;
          change.changed = true;
          here = nearer;
        }
      }
    }
  }
  if (change.changed) {
    scan_maximum(block);
  }
  return change;
}

/// In all blocks that hold some of it; those at the lattice's edge reach half a step beyond it.
void FreeSpace::list_resident(const Newcomer& newcomer, const Pose& pose, std::uint32_t instance) {
  const double half_block = 0.5 * block_side * distances_.spacing();
  const double half_diagonal = std::sqrt(3.0) * (half_block + distances_.spacing());
  for_blocks_near(pose.center, pose.radius, [&](std::size_t block) {
    const dvec3 middle = distances_.point(block_at(block) * block_side) + half_block;
    if (newcomer.least_distance(middle) <= half_diagonal + newcomer.lattice_error()) {
      residents_[block].push_back(instance);
    }
  });
}

void FreeSpace::add(const ShapedElement& shape, const Pose& pose, std::uint32_t instance) {
  const Newcomer newcomer(shape, pose);
  const double half_block = 0.5 * (block_side - 1) * distances_.spacing();
  const double half_diagonal = std::sqrt(3.0) * half_block;
  list_resident(newcomer, pose, instance);
  std::vector<std::size_t> blocks;
  for_blocks_near(pose.center, pose.radius + largest_, [&](std::size_t block) {
    const dvec3 middle = distances_.point(block_at(block) * block_side) + half_block;
    if (maxima_[block] > 0.0F && newcomer.least_distance(middle) - half_diagonal < maxima_[block]) {
      blocks.push_back(block);
    }
  });
  std::vector<Change> changes(blocks.size());
  tbb::parallel_for(std::size_t{0}, blocks.size(),
                    [&](std::size_t b) { changes[b] = add_to_block(blocks[b], newcomer); });
  changed_.clear();
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    points_inside_instances_ += changes[b].filled;
    if (changes[b].changed) {
      changed_.push_back(blocks[b]);
    }
  }
  find_largest();
}

}  // namespace collage
