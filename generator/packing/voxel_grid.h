#pragma once

#include <cstdint>

#include <glm/glm.hpp>

#include "base/rng.h"

namespace collage {

/// Cubic voxels with one sample point each, stored in blocks of 8³ so that neighbours in space are
/// neighbours in memory.
struct VoxelGrid {
  static constexpr int block_side = 8;
  static constexpr std::size_t block_voxels = 512;

  glm::ivec3 size{0};
  /// The corner of the first voxel.
  glm::dvec3 origin{0.0};
  double voxel_side = 1.0;
  /// The sample point lies within this share of the voxel, round its centre (Muhm 2011, III.2).
  double jitter = 0.0;
  std::uint64_t seed = 0;

  [[nodiscard]] glm::ivec3 blocks() const { return (size + (block_side - 1)) / block_side; }
  [[nodiscard]] std::size_t block_count() const {
    const glm::ivec3 n = blocks();
    return static_cast<std::size_t>(n.x) * n.y * n.z;
  }
  [[nodiscard]] glm::ivec3 block_at(std::size_t index) const {
    const glm::ivec3 n = blocks();
    const std::size_t row = index / n.x;
    return {static_cast<int>(index % n.x), static_cast<int>(row % n.y),
            static_cast<int>(row / n.y)};
  }
  [[nodiscard]] std::size_t block_index(const glm::ivec3& block) const {
    const glm::ivec3 n = blocks();
    return (static_cast<std::size_t>(block.z) * n.y + block.y) * n.x + block.x;
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

  [[nodiscard]] glm::dvec3 sample_point(const glm::ivec3& voxel) const {
    const auto key = (static_cast<std::uint64_t>(voxel.z) << 42) |
                     (static_cast<std::uint64_t>(voxel.y) << 21) |
                     static_cast<std::uint64_t>(voxel.x);
    const std::uint64_t bits = mix_bits(mix_bits(seed) ^ key);
    constexpr std::uint64_t mask = (std::uint64_t{1} << 21) - 1;
    const glm::dvec3 uniform =
        glm::dvec3(static_cast<double>(bits & mask), static_cast<double>(bits >> 21 & mask),
                   static_cast<double>(bits >> 42 & mask)) *
        0x1p-21;
    return origin + (glm::dvec3(voxel) + 0.5 + jitter * (uniform - 0.5)) * voxel_side;
  }
};

}  // namespace collage
