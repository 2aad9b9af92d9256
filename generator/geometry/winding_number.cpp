#include "geometry/winding_number.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/gtc/constants.hpp>

namespace collage {
namespace {

constexpr double four_pi = 4.0 * glm::pi<double>();
constexpr std::uint32_t leaf_triangles = 6;
/// A cluster is far from a point at over this many times its radius (Barill's accuracy β).
constexpr double accuracy = 2.0;

/// Sums half solid angles as van Oosterom and Strackee 1983 give them, the argument of a complex
/// number each. Numbers are multiplied, which adds their arguments, as long as the sum cannot pass
/// ±π, so that one arctangent serves for many triangles.
class HalfSolidAngles {
 public:
  /// Triangle abc, seen from the origin.
  void add(const dvec3& a, const dvec3& b, const dvec3& c) {
    const double la = glm::length(a);
    const double lb = glm::length(b);
    const double lc = glm::length(c);
    const double y = glm::dot(a, glm::cross(b, c));
    const double x = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
    if (x > 0.0 && x_ > 0.0) {  // both within ±π/2
      const double product_x = x_ * x - y_ * y;
      y_ = x_ * y + y_ * x;
      x_ = product_x;
      if (!(std::abs(x_) < 1e100 && std::abs(x_) > 1e-100)) {
        flush();
      }
    } else {
      sum_ += std::atan2(y, x);
      flush();
    }
  }
  double sum() {
    flush();
    return sum_;
  }

 private:
  void flush() {
    sum_ += std::atan2(y_, x_);
    x_ = 1.0;
    y_ = 0.0;
  }

  double x_ = 1.0;
  double y_ = 0.0;
  double sum_ = 0.0;
};

}  // namespace

double winding_number(const Mesh& mesh, const dvec3& point) {
  HalfSolidAngles angles;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    angles.add(mesh.corner(t, 0) - point, mesh.corner(t, 1) - point, mesh.corner(t, 2) - point);
  }
  return 2.0 * angles.sum() / four_pi;
}

WindingNumber::WindingNumber(const Mesh& mesh) {
  triangles_.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    triangles_.push_back({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)});
  }
  if (!triangles_.empty()) {
    build(0, static_cast<std::uint32_t>(triangles_.size()));
  }
}

std::uint32_t WindingNumber::build(std::uint32_t begin, std::uint32_t end) {
  const auto self = static_cast<std::uint32_t>(clusters_.size());
  clusters_.emplace_back();
  clusters_[self].begin = begin;
  clusters_[self].end = end;
  summarise(clusters_[self]);
  if (end - begin > leaf_triangles) {
    Box box;
    for (std::uint32_t t = begin; t < end; ++t) {
      box.include(triangles_[t].a + triangles_[t].b + triangles_[t].c);
    }
    const dvec3 extent = box.extent();
    const int axis =
        extent.x >= extent.y ? (extent.x >= extent.z ? 0 : 2) : (extent.y >= extent.z ? 1 : 2);
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(triangles_.begin() + begin, triangles_.begin() + middle,
                     triangles_.begin() + end, [axis](const Triangle& s, const Triangle& t) {
                       return s.a[axis] + s.b[axis] + s.c[axis] < t.a[axis] + t.b[axis] + t.c[axis];
                     });
    build(begin, middle);
    const std::uint32_t second = build(middle, end);
    clusters_[self].second_child = second;
  }
  return self;
}

void WindingNumber::summarise(Cluster& cluster) const {
  double area = 0.0;
  dvec3 weighted(0.0);
  for (std::uint32_t t = cluster.begin; t < cluster.end; ++t) {
    const auto& [a, b, c] = triangles_[t];
    const dvec3 area_vector = 0.5 * glm::cross(b - a, c - a);
    const double weight = glm::length(area_vector);
    area += weight;
    weighted += weight / 3.0 * (a + b + c);
    cluster.dipole += area_vector;
  }
  cluster.center = area > 0.0 ? weighted / area : triangles_[cluster.begin].a;
  double radius_squared = 0.0;
  for (std::uint32_t t = cluster.begin; t < cluster.end; ++t) {
    const auto& [a, b, c] = triangles_[t];
    const dvec3 n = 0.5 * glm::cross(b - a, c - a);
    const dvec3 m = (a + b + c) / 3.0 - cluster.center;
    cluster.moment_diagonal += m * n;
    cluster.moment_mixed +=
        dvec3(m.x * n.y + m.y * n.x, m.y * n.z + m.z * n.y, m.z * n.x + m.x * n.z);
    for (const dvec3& corner : {a, b, c}) {
      const dvec3 d = corner - cluster.center;
      radius_squared = std::max(radius_squared, glm::dot(d, d));
    }
  }
  cluster.far_distance_squared = accuracy * accuracy * radius_squared;
}

double WindingNumber::at(const dvec3& point) const {
  double far_sum = 0.0;  // in units of 4π
  HalfSolidAngles near;
  std::array<std::uint32_t, 64> stack;
  std::size_t depth = 0;
  if (!clusters_.empty()) {
    stack[depth++] = 0;
  }
  while (depth > 0) {
    const std::uint32_t index = stack[--depth];
    const Cluster& cluster = clusters_[index];
    const dvec3 r = cluster.center - point;
    const double squared = glm::dot(r, r);
    if (squared > cluster.far_distance_squared) {
      const double inverse_squared = 1.0 / squared;
      const double inverse_cubed = inverse_squared * std::sqrt(inverse_squared);
      const double trace =
          cluster.moment_diagonal.x + cluster.moment_diagonal.y + cluster.moment_diagonal.z;
      const double quadratic =
          glm::dot(cluster.moment_diagonal, r * r) +
          glm::dot(cluster.moment_mixed, dvec3(r.x * r.y, r.y * r.z, r.z * r.x));
      far_sum +=
          inverse_cubed * (glm::dot(cluster.dipole, r) + trace - 3.0 * quadratic * inverse_squared);
    } else if (cluster.second_child == 0) {
      for (std::uint32_t t = cluster.begin; t < cluster.end; ++t) {
        const auto& [a, b, c] = triangles_[t];
        near.add(a - point, b - point, c - point);
      }
    } else {
      stack[depth++] = cluster.second_child;
      stack[depth++] = index + 1;
    }
  }
  return (far_sum + 2.0 * near.sum()) / four_pi;
}

}  // namespace collage
