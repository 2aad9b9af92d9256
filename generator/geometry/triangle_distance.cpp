#include "geometry/triangle_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/closest_point.h"

namespace collage {
namespace {

double squared_length(const glm::dvec3& v) { return glm::dot(v, v); }

/// Least squared distance from a corner of `s` to `t`.
double corners_to_face(const Corners& s, const Corners& t) {
  double least = std::numeric_limits<double>::infinity();
  for (const glm::dvec3& corner : s) {
    // Not a number where `t` has no area; then the edges tell.
    const glm::dvec3 closest = closest_point_on_triangle(corner, t[0], t[1], t[2]);
    least = std::min(least, squared_length(corner - closest));
  }
  return least;
}

}  // namespace

double squared_segment_distance(const glm::dvec3& p1, const glm::dvec3& q1, const glm::dvec3& p2,
                                const glm::dvec3& q2) {
  const glm::dvec3 d1 = q1 - p1;
  const glm::dvec3 d2 = q2 - p2;
  const glm::dvec3 r = p1 - p2;
  const double a = glm::dot(d1, d1);
  const double e = glm::dot(d2, d2);
  const double f = glm::dot(d2, r);
  // The parameters of the closest points; a segment that is a point keeps 0.
  double s = 0.0;
  double t = 0.0;
  if (a == 0.0) {
    t = e > 0.0 ? std::clamp(f / e, 0.0, 1.0) : 0.0;
  } else if (e == 0.0) {
    s = std::clamp(-glm::dot(d1, r) / a, 0.0, 1.0);
  } else {
    const double b = glm::dot(d1, d2);
    const double c = glm::dot(d1, r);
    const double denominator = a * e - b * b;
    s = denominator > 0.0 ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0.0;
    t = (b * s + f) / e;
    if (t < 0.0 || t > 1.0) {
      t = std::clamp(t, 0.0, 1.0);
      s = std::clamp((b * t - c) / a, 0.0, 1.0);
    }
  }
  return squared_length(r + s * d1 - t * d2);
}

double triangle_distance(const Corners& s, const Corners& t) {
  if (triangles_intersect(s, t)) {
    return 0.0;
  }
  double least = std::min(corners_to_face(s, t), corners_to_face(t, s));
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      least = std::min(least, squared_segment_distance(s[i], s[(i + 1) % 3], t[j], t[(j + 1) % 3]));
    }
  }
  return std::sqrt(least);
}

}  // namespace collage
