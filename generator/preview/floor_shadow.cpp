#include "preview/floor_shadow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <glm/gtc/constants.hpp>
#include <tbb/parallel_for.h>

namespace collage {
namespace {

constexpr double golden_angle = 2.39996323;

/// A point looks along one of the patterns, its neighbours along the others.
constexpr std::size_t patterns = 4;
using Directions = std::array<std::vector<dvec3>, patterns>;

/// Round the key light, and over the sky in proportion to their height, both by the golden angle.
Directions directions(const FloorLight& light, const Bearing& bearing, int rays) {
  const dvec3 side = glm::normalize(glm::cross(dvec3(0, 1, 0), light.key));
  const dvec3 over = glm::cross(light.key, side);
  const double reach = std::tan(glm::radians(0.5 * light.key_width_degrees));
  const int all = static_cast<int>(patterns) * rays;
  const int key_rays = static_cast<int>(patterns * std::floor(rays * light.key_share + 0.5));
  Directions result;
  for (int k = 0; k < all; ++k) {
    const double turn = golden_angle * k;
    const bool is_key = k < key_rays;
    const double rank = (is_key ? k : k - key_rays) + 0.5;
    const double off = std::sqrt(rank / (is_key ? key_rays : all - key_rays));
    const dvec3 direction =
        is_key ? glm::normalize(light.key +
                                reach * off * (std::cos(turn) * side + std::sin(turn) * over))
               : dvec3(off * std::cos(turn), std::sqrt(1.0 - off * off), off * std::sin(turn));
    result[static_cast<std::size_t>(k) % patterns].push_back(turned(direction, bearing));
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

double FloorShadow::place(double step) const {
  const double u = 2.0 * step / steps_ - 1.0;
  return u * (0.5 + 0.5 * u * u);
}

/// The real root of u³ + u = 2 place.
double FloorShadow::step_at(double place) const {
  const double u = 2.0 / std::sqrt(3.0) * std::sinh(std::asinh(3.0 * std::sqrt(3.0) * place) / 3.0);
  return 0.5 * steps_ * (u + 1.0);
}

FloorShadow::FloorShadow(const InstancedScene& sculpture, const Stand& stand,
                         const Bearing& bearing, const FloorLight& light,
                         const ShadowFineness& fineness)
    : bearing_(bearing), steps_(fineness.steps), radius_(stand.radius + 0.5 + 0.9 * stand.height) {
  const Directions toward_light = directions(light, bearing, fineness.rays);
  // First for points half a step off the grid, then for the grid's, the mean of the four round
  // each.
  const std::size_t side = static_cast<std::size_t>(steps_) + 4;
  std::vector<double> single(side * side);
  tbb::parallel_for(std::size_t{0}, side, [&](std::size_t j) {
    for (std::size_t i = 0; i < side; ++i) {
      const dvec3 share(place(static_cast<double>(i) - 1.5), 0.0,
                        place(static_cast<double>(j) - 1.5));
      const double fade = smoothstep((1.0 - glm::length(share)) / 0.5);
      if (fade == 0.0) {
        continue;
      }
      const dvec3 point = turned(radius_ * share, bearing);
      const std::vector<dvec3>& toward = toward_light[i % 2 + 2 * (j % 2)];
      const auto count = std::ranges::count_if(toward, [&](const dvec3& direction) {
        return sculpture.occluded({point, direction});
      });
      single[j * side + i] = fade * static_cast<double>(count) / fineness.rays;
    }
  });
  stopped_.reserve((side - 1) * (side - 1));
  for (std::size_t j = 0; j + 1 < side; ++j) {
    for (std::size_t i = 0; i + 1 < side; ++i) {
      const double* corner = &single[j * side + i];
      stopped_.push_back((corner[0] + corner[1] + corner[side] + corner[side + 1]) / 4.0);
    }
  }
}

double FloorShadow::stopped(double x, double z) const {
  if (!(std::hypot(x, z) < radius_)) {
    return 0.0;
  }
  const dvec3 seen = turned({x, 0.0, z}, {-bearing_.azimuth_degrees, 0.0});
  const double across = step_at(seen.x / radius_);
  const double along = step_at(seen.z / radius_);
  const int i = std::clamp(static_cast<int>(across), 0, steps_ - 1);
  const int j = std::clamp(static_cast<int>(along), 0, steps_ - 1);
  const auto weights_i = spline_weights(across - i);
  const auto weights_j = spline_weights(along - j);
  double sum = 0.0;
  for (int dj = 0; dj < 4; ++dj) {
    const std::size_t row =
        static_cast<std::size_t>(j + dj) * static_cast<std::size_t>(control_count()) +
        static_cast<std::size_t>(i);
    for (int di = 0; di < 4; ++di) {
      sum += weights_j[static_cast<std::size_t>(dj)] * weights_i[static_cast<std::size_t>(di)] *
             stopped_[row + static_cast<std::size_t>(di)];
    }
  }
  return std::min(sum, 1.0);  // the weights may add up to a rounding more
}

}  // namespace collage
