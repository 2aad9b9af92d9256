#pragma once

#include <cstdint>

#include <glm/glm.hpp>

#include "base/rng.h"

namespace collage {

/// Cubic voxels with one sample point each, stored in blocks of 4³, and these in groups of 2³, so
/// that neighbours in space are neighbours in memory.
struct VoxelGrid {
  static constexpr int block_side = 4;
  static constexpr std::size_t block_voxels = 64;
  static constexpr int group_side = 2 * block_side;
  static constexpr std::size_t group_blocks = 8;

  glm::ivec3 size{0};
  /// The corner of the first voxel.
  glm::dvec3 origin{0.0};
  double voxel_side = 1.0;
  /// The sample point lies within this share of the voxel, round its centre (Muhm 2011, III.2).
  double jitter = 0.0;
  std::uint64_t seed = 0;

  [[nodiscard]] glm::ivec3 groups() const { return (size + (group_side - 1)) / group_side; }
  [[nodiscard]] std::size_t block_count() const {
    const glm::ivec3 n = groups();
    return group_blocks * n.x * n.y * n.z;
  }
  /// Which of the blocks along each axis it is.
  [[nodiscard]] glm::ivec3 block_at(std::size_t index) const {
    const glm::uvec3 n(groups());
    const auto group = static_cast<std::uint32_t>(index / group_blocks);
    const std::uint32_t row = group / n.x;
    return 2 * glm::ivec3(group % n.x, row % n.y, row / n.y) + octant(index);
  }
  [[nodiscard]] std::size_t block_index(const glm::ivec3& block) const {
    const glm::ivec3 n = groups();
    const glm::ivec3 group = block / 2;
    const std::size_t row = static_cast<std::size_t>(group.z) * n.y + group.y;
    return (row * n.x + group.x) * group_blocks +
           static_cast<std::size_t>((block.z % 2 * 2 + block.y % 2) * 2 + block.x % 2);
  }
  /// Where in its group a block is.
  static glm::ivec3 octant(std::size_t index) {
    const int i = static_cast<int>(index % group_blocks);
    return {i % 2, i / 2 % 2, i / 4};
  }
  /// Where in its block a voxel is stored; `local` counts from the block's first voxel.
  static std::size_t slot(const glm::ivec3& local) {
    const int index = (local.z * block_side + local.y) * block_side + local.x;
    return static_cast<std::size_t>(index);
  }
  static glm::ivec3 local_at(std::size_t slot) {
    const int s = static_cast<int>(slot);
    return {s % block_side, s / block_side % block_side, s / (block_side * block_side)};
  }

  /// Where in its voxel a sample point is drawn: three integers below 2²¹.
  [[nodiscard]] glm::ivec3 draw(const glm::ivec3& voxel) const {
    const auto key = (static_cast<std::uint64_t>(voxel.z) << 42) |
                     (static_cast<std::uint64_t>(voxel.y) << 21) |
                     static_cast<std::uint64_t>(voxel.x);
    const std::uint64_t bits = mix_bits(mix_bits(seed) ^ key);
    constexpr std::uint64_t mask = (std::uint64_t{1} << 21) - 1;
    return {static_cast<int>(bits & mask), static_cast<int>(bits >> 21 & mask),
            static_cast<int>(bits >> 42 & mask)};
  }
  [[nodiscard]] glm::dvec3 sample_point(const glm::ivec3& voxel) const {
    const glm::dvec3 uniform = glm::dvec3(draw(voxel)) * 0x1p-21;
    return origin + (glm::dvec3(voxel) + 0.5 + jitter * (uniform - 0.5)) * voxel_side;
  }
};

}  // namespace collage
