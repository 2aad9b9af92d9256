#include "preview/floor_shadow.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/gtc/constants.hpp>
#include <tbb/parallel_for.h>

#include "preview/studio.h"

namespace collage {
namespace {

constexpr std::size_t rays_a_point = 64;
constexpr double golden_angle = 2.39996323;

using Directions = std::array<dvec3, rays_a_point>;

/// Round the key light, and over the sky in proportion to their height, both by the golden angle.
Directions directions(const dvec3& key) {
  const dvec3 side = glm::normalize(glm::cross(dvec3(0, 1, 0), key));
  const dvec3 over = glm::cross(key, side);
  const auto key_rays = static_cast<std::size_t>(std::lround(rays_a_point * key_share));
  const double reach = std::tan(glm::radians(0.5 * key_width_degrees));
  Directions result;
  for (std::size_t k = 0; k < rays_a_point; ++k) {
    const double turn = golden_angle * static_cast<double>(k);
    const bool is_key = k < key_rays;
    const auto rank = static_cast<double>(is_key ? k : k - key_rays) + 0.5;
    const double off =
        std::sqrt(rank / static_cast<double>(is_key ? key_rays : rays_a_point - key_rays));
    result[k] =
        is_key ? glm::normalize(key + reach * off * (std::cos(turn) * side + std::sin(turn) * over))
               : dvec3(off * std::cos(turn), std::sqrt(1.0 - off * off), off * std::sin(turn));
  }
  return result;
}

double smoothstep(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// Weights of four points in a row, a fraction of the way from the second to the third.
std::array<double, 4> spline_weights(double f) {
  const double g = 1.0 - f;
  const double first = g * g * g / 6.0;
  const double second = (3.0 * f * f * f - 6.0 * f * f + 4.0) / 6.0;
  const double last = f * f * f / 6.0;
  return {first, second, 1.0 - first - second - last, last};
}

}  // namespace

double FloorShadow::place(double step) {
  const double u = 2.0 * step / steps - 1.0;
  return u * (0.5 + 0.5 * u * u);
}

/// The real root of u³ + u = 2 place.
double FloorShadow::step_at(double place) {
  const double u = 2.0 / std::sqrt(3.0) * std::sinh(std::asinh(3.0 * std::sqrt(3.0) * place) / 3.0);
  return 0.5 * steps * (u + 1.0);
}

FloorShadow::FloorShadow(const InstancedScene& sculpture, const Stand& stand,
                         const Bearing& bearing)
    : radius_(stand.radius + 0.5 + 0.9 * stand.height) {
  const Directions toward_light = directions(key_direction(bearing));
  tbb::parallel_for(-1, steps + 2, [&](int j) {
    std::array<Ray, rays_a_point> rays;
    std::array<std::uint8_t, rays_a_point> is_stopped{};
    for (int i = -1; i <= steps + 1; ++i) {
      const dvec3 point = radius_ * dvec3(place(i), 0.0, place(j));
      const double fade = smoothstep((1.0 - glm::length(point) / radius_) / 0.5);
      if (fade == 0.0) {
        continue;
      }
      for (std::size_t k = 0; k < rays_a_point; ++k) {
        rays[k] = {point, toward_light[k]};
      }
      sculpture.occluded(rays, is_stopped);
      const auto count = std::count(is_stopped.begin(), is_stopped.end(), std::uint8_t{1});
      at(i, j) = fade * static_cast<double>(count) / rays_a_point;
    }
  });
}

double FloorShadow::stopped(double x, double z) const {
  if (!(std::hypot(x, z) < radius_)) {
    return 0.0;
  }
  const double across = step_at(x / radius_);
  const double along = step_at(z / radius_);
  const int i = std::clamp(static_cast<int>(across), 0, steps - 1);
  const int j = std::clamp(static_cast<int>(along), 0, steps - 1);
  const auto weights_i = spline_weights(across - i);
  const auto weights_j = spline_weights(along - j);
  double sum = 0.0;
  for (int dj = 0; dj < 4; ++dj) {
    const auto row = static_cast<std::size_t>((j + dj) * side + i);
    for (int di = 0; di < 4; ++di) {
      sum += weights_j[static_cast<std::size_t>(dj)] * weights_i[static_cast<std::size_t>(di)] *
             stopped_[row + static_cast<std::size_t>(di)];
    }
  }
  return std::min(sum, 1.0);  // the weights may add up to a rounding more
}

}  // namespace collage
