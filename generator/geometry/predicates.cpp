#include "geometry/predicates.h"

#include <cmath>

#include <gmpxx.h>

namespace collage {
namespace {

constexpr double epsilon = 0x1p-53;
constexpr double orient3d_bound = (7.0 + 56.0 * epsilon) * epsilon;
constexpr double orient2d_bound = (3.0 + 16.0 * epsilon) * epsilon;
/// Below this a product may have lost bits to underflow, and the bounds do not hold.
constexpr double safe_minimum = 1e-290;

int sign(double x) { return x > 0.0 ? 1 : (x < 0.0 ? -1 : 0); }

struct Exact3 {
  mpq_class x, y, z;
  Exact3(const glm::dvec3& p, const glm::dvec3& origin)
      : x(mpq_class(p.x) - origin.x), y(mpq_class(p.y) - origin.y), z(mpq_class(p.z) - origin.z) {}
};

int orient3d_exact(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                   const glm::dvec3& d) {
  const Exact3 u(a, d);
  const Exact3 v(b, d);
  const Exact3 w(c, d);
  const mpq_class determinant =
      u.x * (v.y * w.z - v.z * w.y) + v.x * (w.y * u.z - w.z * u.y) + w.x * (u.y * v.z - u.z * v.y);
  return sgn(determinant);
}

int orient2d_exact(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  const mpq_class left = (mpq_class(a.x) - c.x) * (mpq_class(b.y) - c.y);
  const mpq_class right = (mpq_class(a.y) - c.y) * (mpq_class(b.x) - c.x);
  return cmp(left, right);
}

}  // namespace

int orient3d(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  const glm::dvec3 u = a - d;
  const glm::dvec3 v = b - d;
  const glm::dvec3 w = c - d;
  const double vw = v.x * w.y;
  const double wv = w.x * v.y;
  const double wu = w.x * u.y;
  const double uw = u.x * w.y;
  const double uv = u.x * v.y;
  const double vu = v.x * u.y;
  const double determinant = u.z * (vw - wv) + v.z * (wu - uw) + w.z * (uv - vu);
  const double size = (std::abs(vw) + std::abs(wv)) * std::abs(u.z) +
                      (std::abs(wu) + std::abs(uw)) * std::abs(v.z) +
                      (std::abs(uv) + std::abs(vu)) * std::abs(w.z);
  if (std::abs(determinant) > orient3d_bound * size && size > safe_minimum) {
    return sign(determinant);
  }
  return orient3d_exact(a, b, c, d);
}

int orient2d(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double determinant = left - right;
  const double size = std::abs(left) + std::abs(right);
  if (std::abs(determinant) > orient2d_bound * size && size > safe_minimum) {
    return sign(determinant);
  }
  return orient2d_exact(a, b, c);
}

}  // namespace collage
