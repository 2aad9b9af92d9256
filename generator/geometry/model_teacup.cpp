#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "geometry/model_materials.h"
#include "geometry/models.h"
#include "geometry/smooth_normals.h"
#include "geometry/sweep.h"

namespace collage {
namespace {

constexpr double crease_degrees = 75.0;

/// The profile outside, from the middle of the underside to the rim, and inside, down again.
constexpr std::array<ProfilePoint, 6> outside = {
    {{0.0, 0.05}, {0.45, 0.0}, {0.47, 0.1}, {0.74, 0.25}, {0.905, 0.6}, {1.0, 1.22}}};
constexpr std::array<ProfilePoint, 4> inside = {
    {{0.935, 1.235}, {0.825, 0.62}, {0.64, 0.3}, {0.0, 0.15}}};

/// The radius of a profile at a height, halfway between facets' edges, where the wall is nearest.
double radius_at(std::span<const ProfilePoint> profile, double height, int segments) {
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const auto [low, high] = std::minmax(profile[i].y, profile[i + 1].y);
    if (height >= low && height <= high) {
      const double t = (height - profile[i].y) / (profile[i + 1].y - profile[i].y);
      const double radius = profile[i].x + t * (profile[i + 1].x - profile[i].x);
      return radius * std::cos(std::numbers::pi / segments);
    }
  }
  return 0.0;
}

/// The middle of the wall at a height, over +x.
dvec2 middle_of_wall(double height, int segments) {
  const double outer = radius_at(outside, height, segments);
  const double inner = radius_at(std::span(inside).first<3>(), height, segments);
  return {0.5 * (outer + inner), height};
}

/// The handle's middle line in the plane z = 0: one cubic Bézier curve, which leaves the wall and
/// meets it again at right angles.
class HandlePath {
 public:
  explicit HandlePath(int segments) {
    const dvec2 upper = middle_of_wall(1.02, segments);
    const dvec2 lower = middle_of_wall(0.44, segments);
    control_ = {upper, upper + dvec2(0.98, 0.2), lower + dvec2(0.72, -0.26), lower};
  }

  dvec2 point(double t) const {
    const double s = 1.0 - t;
    return s * s * s * control_[0] + 3.0 * s * s * t * control_[1] + 3.0 * s * t * t * control_[2] +
           t * t * t * control_[3];
  }
  dvec2 direction(double t) const {
    const double s = 1.0 - t;
    return glm::normalize(s * s * (control_[1] - control_[0]) +
                          2.0 * s * t * (control_[2] - control_[1]) +
                          t * t * (control_[3] - control_[2]));
  }

 private:
  std::array<dvec2, 4> control_;
};

/// An ellipse across the path, broad along z, a little fuller at the wall.
Ring handle_ring(const HandlePath& path, double t, int corners) {
  const dvec2 along = path.direction(t);
  const dvec3 across(-along.y, along.x, 0.0);
  const double fullness = 1.0 + 0.3 * std::pow(2.0 * t - 1.0, 4.0);
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners;
    ring.push_back(
        dvec3(path.point(t), 0.0) +
        fullness * (0.055 * std::cos(angle) * across + dvec3(0.0, 0.0, 0.085 * std::sin(angle))));
  }
  return ring;
}

}  // namespace

Mesh make_teacup(int segments) {
  assert(segments >= 8);
  std::vector<ProfilePoint> profile(outside.begin(), outside.end());
  profile.insert(profile.end(), inside.begin(), inside.end());
  Mesh mesh;
  // A facet, not an edge, faces the handle.
  append_rings(mesh, lathe(profile, segments, std::numbers::pi / segments));
  const HandlePath path(segments);
  const int steps = segments / 2;
  std::vector<Ring> rings;
  for (int i = 0; i <= steps; ++i) {
    rings.push_back(handle_ring(path, static_cast<double>(i) / steps, 6));
  }
  append_rings(mesh, rings);
  set_smooth_normals(mesh, crease_degrees);
  mesh.materials.push_back(glaze("glaze", {0.86, 0.83, 0.76}));
  return mesh;
}

}  // namespace collage
