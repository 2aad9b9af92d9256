#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

namespace collage {

/// A surface that clearances are measured to: the target's or that of instance `id - 1`.
using SurfaceId = std::uint32_t;
inline constexpr SurfaceId target_surface = 0;
/// More instances than this cannot be told apart.
inline constexpr SurfaceId most_surfaces = (1U << 24) - 2;
/// Which of several surfaces is the nearest has not been found out.
inline constexpr SurfaceId several_surfaces = most_surfaces + 1;

/// Which surface is nearest to a voxel, and how far below the stored upper bound the clearance may
/// lie: the gap, in voxels, rounded up to 3 bits of mantissa and 5 of exponent. 4 bytes.
class NearestSurface {
 public:
  NearestSurface() = default;
  explicit NearestSurface(SurfaceId id) : bits_(id) {}
  /// `gap_voxels` ≥ 0.
  NearestSurface(SurfaceId id, float gap_voxels) : bits_(id | code(gap_voxels) << 24) {}
  bool operator==(const NearestSurface&) const = default;

  [[nodiscard]] SurfaceId id() const { return bits_ & several_surfaces; }
  [[nodiscard]] bool is_exact() const { return bits_ >> 24 == 0; }
  /// For a bound in world units. Not below 0.
  [[nodiscard]] float lower(float upper, float voxel_side) const {
    if (is_exact()) {
      return upper;
    }
    if (bits_ >> 24 == largest_code) {  // that or more
      return 0.0F;
    }
    const auto gap = std::bit_cast<float>(((bits_ >> 24) + smallest_bits) << 20);
    // A unit in the last place of the bound may be lost in the difference.
    return std::max(0.0F, upper * (1.0F - 0x1p-23F) - gap * voxel_side);
  }

 private:
  static constexpr std::uint32_t largest_code = 255;
  /// The upper bits of 2⁻¹⁶.
  static constexpr std::uint32_t smallest_bits = (127U - 16U) << 3;

  static std::uint32_t code(float gap) {
    constexpr std::uint32_t cut = (1U << 20) - 1;
    const std::uint32_t upper_bits = (std::bit_cast<std::uint32_t>(gap) + cut) >> 20;
    return std::clamp(upper_bits, smallest_bits + 1, smallest_bits + largest_code) - smallest_bits;
  }

  std::uint32_t bits_ = 0;
};

}  // namespace collage
