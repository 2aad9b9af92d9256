#include "geometry/polygon.h"

#include <cmath>

namespace collage {
namespace {

using Triangle = std::array<int, 3>;

double cross(const dvec2& a, const dvec2& b) { return a.x * b.y - a.y * b.x; }

/// Twice the area as a vector, by Newell's method; about the first corner, where nothing cancels.
dvec3 area_vector(std::span<const dvec3> corners) {
  dvec3 sum(0.0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  }
  return sum;
}

/// The corners in a plane's coordinates in which the polygon runs counter-clockwise.
std::vector<dvec2> flatten(std::span<const dvec3> corners) {
  const dvec3 normal = glm::normalize(area_vector(corners));
  const dvec3 helper = std::abs(normal.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
  const dvec3 u = glm::normalize(glm::cross(helper, normal));
  const dvec3 v = glm::cross(normal, u);
  std::vector<dvec2> flat;
  for (const dvec3& corner : corners) {
    flat.emplace_back(glm::dot(corner - corners[0], u), glm::dot(corner - corners[0], v));
  }
  return flat;
}

/// The corners that are left, as a ring of links.
class EarClipper {
 public:
  explicit EarClipper(std::vector<dvec2> points) : points_(std::move(points)) {
    const int n = static_cast<int>(points_.size());
    for (int i = 0; i < n; ++i) {
      next_.push_back((i + 1) % n);
      previous_.push_back((i + n - 1) % n);
    }
    for (int i = 0; i < n; ++i) {
      if (turn(i) <= 0) {
        reflex_.push_back(i);
      }
    }
  }

  std::vector<Triangle> run() {
    std::vector<Triangle> triangles;
    int corner = 0;
    int refused = 0;
    for (int left = static_cast<int>(points_.size()); left > 2;) {
      // After a whole round without an ear the polygon crosses itself or is flat: cut anything.
      if (refused < left && !is_ear(corner)) {
        corner = next_[corner];
        ++refused;
        continue;
      }
      triangles.push_back({previous_[corner], corner, next_[corner]});
      corner = next_[cut(corner)];  // every other one, for triangles that are not all thin
      refused = 0;
      --left;
    }
    return triangles;
  }

 private:
  /// 1 where the polygon turns left, -1 right, 0 straight on (by rounding, too).
  int turn(int i) const {
    const dvec2 a = points_[i] - points_[previous_[i]];
    const dvec2 b = points_[next_[i]] - points_[i];
    const double area = cross(a, b);
    const double noise = 1e-14 * glm::length(a) * glm::length(b);
    return area > noise ? 1 : area < -noise ? -1 : 0;
  }

  bool is_ear(int i) {
    if (turn(i) <= 0) {
      return false;
    }
    std::erase_if(reflex_, [&](int k) { return next_[k] < 0 || turn(k) > 0; });
    for (const int k : reflex_) {
      if (k != previous_[i] && k != next_[i] && blocks(k, i)) {
        return false;
      }
    }
    return true;
  }

  /// Whether corner k lies in the ear at i or on its rim; one at the same place as a corner of the
  /// ear does not block, for a bridge to a hole passes there twice.
  bool blocks(int k, int i) const {
    const dvec2 a = points_[previous_[i]];
    const dvec2 b = points_[i];
    const dvec2 c = points_[next_[i]];
    const dvec2 p = points_[k];
    return p != a && p != b && p != c && cross(b - a, p - a) >= 0 && cross(c - b, p - b) >= 0 &&
           cross(a - c, p - c) >= 0;
  }

  /// Takes corner i out and returns the one behind it.
  int cut(int i) {
    const int after = next_[i];
    next_[previous_[i]] = after;
    previous_[after] = previous_[i];
    next_[i] = -1;
    return after;
  }

  std::vector<dvec2> points_;
  std::vector<int> next_;  // -1: cut off
  std::vector<int> previous_;
  std::vector<int> reflex_;  // a superset of the corners left that do not turn left
};

/// The two triangles on the shorter diagonal, where both turn the same way as the quad.
std::vector<Triangle> split_convex_quad(std::span<const dvec3> c) {
  const dvec3 normal = area_vector(c);
  for (int i = 0; i < 4; ++i) {
    const dvec3 edge = c[(i + 1) % 4] - c[i];
    if (glm::dot(glm::cross(edge, c[(i + 2) % 4] - c[i]), normal) <= 0) {
      return {};
    }
  }
  if (glm::distance(c[0], c[2]) <= glm::distance(c[1], c[3])) {
    return {{0, 1, 2}, {0, 2, 3}};
  }
  return {{0, 1, 3}, {1, 2, 3}};
}

}  // namespace

std::vector<Triangle> triangulate(std::span<const dvec3> corners) {
  if (corners.size() < 3) {
    return {};
  }
  if (corners.size() == 3) {
    return {{0, 1, 2}};
  }
  if (corners.size() == 4) {
    if (auto triangles = split_convex_quad(corners); !triangles.empty()) {
      return triangles;
    }
  }
  if (glm::length(area_vector(corners)) == 0.0) {
    return EarClipper(std::vector<dvec2>(corners.size(), dvec2(0.0))).run();
  }
  return EarClipper(flatten(corners)).run();
}

}  // namespace collage
