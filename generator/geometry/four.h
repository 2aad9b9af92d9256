#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include <glm/glm.hpp>

namespace collage {

/// Four floats or two doubles at once, by vector instructions where the processor has them. The
/// results of each are those of a scalar.
using Four = float __attribute__((vector_size(16)));
using FourIntegers = std::int32_t __attribute__((vector_size(16)));
using FloatPair = float __attribute__((vector_size(8)));
using Two = double __attribute__((vector_size(16)));
inline constexpr std::size_t four_lanes = 4;
/// Points: their x, y and z.
template <class Numbers>
using Points = std::array<Numbers, 3>;

inline Four all_four(float x) { return Four{x, x, x, x}; }
inline Points<Four> all_four(const glm::vec3& point) {
  return {all_four(point.x), all_four(point.y), all_four(point.z)};
}
inline Points<Two> both(const glm::dvec3& point) {
  return {Two{point.x, point.x}, Two{point.y, point.y}, Two{point.z, point.z}};
}
inline Four absolute(Four x) {
  return std::bit_cast<Four>(std::bit_cast<FourIntegers>(x) & 0x7fffffff);
}
inline Four larger(Four a, Four b) { return a > b ? a : b; }
inline Four square_root(Four x) {
  return Four{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])};
}
inline Two square_root(Two x) { return Two{std::sqrt(x[0]), std::sqrt(x[1])}; }
inline float sum(Four x) { return (x[0] + x[1]) + (x[2] + x[3]); }
inline std::size_t least_lane(Four x) {
  const std::size_t low = x[1] < x[0] ? 1 : 0;
  const std::size_t high = x[3] < x[2] ? 3 : 2;
  return x[high] < x[low] ? high : low;
}

inline FloatPair pair_at(const float* first) {
  FloatPair pair;
  std::memcpy(&pair, first, sizeof pair);
  return pair;
}
/// The pairs' first numbers, and their second ones.
inline std::array<Four, 2> transposed(FloatPair a, FloatPair b, FloatPair c, FloatPair d) {
  const Four ab = __builtin_shufflevector(a, b, 0, 1, 2, 3);
  const Four cd = __builtin_shufflevector(c, d, 0, 1, 2, 3);
  return {__builtin_shufflevector(ab, cd, 0, 2, 4, 6), __builtin_shufflevector(ab, cd, 1, 3, 5, 7)};
}

template <class Numbers>
Points<Numbers> operator-(const Points<Numbers>& a, const Points<Numbers>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class Numbers>
Numbers dot(const Points<Numbers>& a, const Points<Numbers>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class Numbers>
Points<Numbers> cross(const Points<Numbers>& a, const Points<Numbers>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class Numbers>
void set_lane(Points<Numbers>& points, std::size_t lane, const glm::dvec3& point) {
  for (int axis = 0; axis < 3; ++axis) {
    Numbers& numbers = points[static_cast<std::size_t>(axis)];
    numbers[lane] = static_cast<std::remove_cvref_t<decltype(numbers[0])>>(point[axis]);
  }
}

}  // namespace collage
