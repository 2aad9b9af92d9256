#include "geometry/bounding_sphere.h"

#include <cassert>
#include <cmath>
#include <vector>

namespace collage {
namespace {

constexpr int max_pivots = 1000;  // a guard; rounding alone could make it turn in circles

/// The centre of the smallest sphere through all points of `support`, 1 to 4 of them; not finite
/// where they do not define one.
dvec3 circumcenter(std::span<const dvec3> support) {
  const dvec3 origin = support[0];
  if (support.size() == 1) {
    return origin;
  }
  const dvec3 a = support[1] - origin;
  if (support.size() == 2) {
    return origin + 0.5 * a;
  }
  const dvec3 b = support[2] - origin;
  const dvec3 normal = glm::cross(a, b);
  if (support.size() == 3) {
    const dvec3 towards = glm::dot(a, a) * b - glm::dot(b, b) * a;
    return origin + glm::cross(towards, normal) / (2.0 * glm::dot(normal, normal));
  }
  const dvec3 c = support[3] - origin;
  const dvec3 sum = glm::dot(a, a) * glm::cross(b, c) + glm::dot(b, b) * glm::cross(c, a) +
                    glm::dot(c, c) * normal;
  return origin + sum / (2.0 * glm::dot(c, normal));
}

/// A sphere held by few points.
struct Basis {
  std::vector<dvec3> support;
  Sphere sphere;
};

/// The points of `candidates` that `subset` has a bit for, and the last, which is always in.
std::vector<dvec3> choose(std::span<const dvec3> candidates, unsigned subset) {
  std::vector<dvec3> chosen;
  for (std::size_t i = 0; i + 1 < candidates.size(); ++i) {
    if ((subset >> i & 1U) != 0) {
      chosen.push_back(candidates[i]);
    }
  }
  chosen.push_back(candidates.back());
  return chosen;
}

/// The smallest sphere of at most five points, the last of which is known to lie on it. Every
/// centre tried costs the radius that it needs to enclose all; the best has the least cost,
/// whatever rounding did to the others. Of equally good ones the one with the fewest points.
Basis smallest_basis(std::span<const dvec3> candidates) {
  Basis best;
  best.sphere.radius = INFINITY;
  for (std::size_t size = 1; size <= 4; ++size) {
    for (unsigned subset = 0; subset < 1U << (candidates.size() - 1); ++subset) {
      std::vector<dvec3> support = choose(candidates, subset);
      if (support.size() != size) {
        continue;
      }
      const dvec3 center = circumcenter(support);
      const double cost = farthest_point(candidates, center).distance;
      if (cost < best.sphere.radius) {
        best = {std::move(support), {center, cost}};
      }
    }
  }
  return best;
}

}  // namespace

FarthestPoint farthest_point(std::span<const dvec3> points, const dvec3& center) {
  FarthestPoint farthest;
  farthest.distance = -1.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double distance = glm::distance(points[i], center);
    if (!(distance <= farthest.distance)) {  // a NaN is farther than anything
      farthest.index = i;
      farthest.distance = distance;
    }
  }
  if (farthest.distance > 0.0) {
    farthest.direction = glm::normalize(points[farthest.index] - center);
  }
  return farthest;
}

Sphere smallest_enclosing_sphere(std::span<const dvec3> points) {
  assert(!points.empty());
  Basis basis = {{points[0]}, {points[0], 0.0}};
  FarthestPoint pivot = farthest_point(points, basis.sphere.center);
  Sphere best = {basis.sphere.center, pivot.distance};
  for (int i = 0; i < max_pivots && pivot.distance > basis.sphere.radius; ++i) {
    std::vector<dvec3> candidates = basis.support;
    candidates.push_back(points[pivot.index]);
    Basis larger = smallest_basis(candidates);
    if (!(larger.sphere.radius > basis.sphere.radius)) {
      break;  // as good as rounding allows
    }
    basis = std::move(larger);
    pivot = farthest_point(points, basis.sphere.center);
    if (pivot.distance < best.radius) {
      best = {basis.sphere.center, pivot.distance};
    }
  }
  // A computed distance is short of the true one by less than three roundings.
  best.radius *= 1.0 + 0x1p-51;
  return best;
}

}  // namespace collage
