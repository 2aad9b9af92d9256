#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "geometry/frames.h"
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

/// Along a Bézier curve in the plane z = 0 that leaves the wall and meets it again at right angles;
/// an ellipse across, broad along z, a little fuller at the wall.
std::vector<Ring> handle(int segments) {
  const dvec3 upper(middle_of_wall(1.02, segments), 0.0);
  const dvec3 lower(middle_of_wall(0.44, segments), 0.0);
  const int steps = segments / 2;
  const auto curve = bezier_curve(upper, upper + dvec3(0.98, 0.2, 0.0),
                                  lower + dvec3(0.72, -0.26, 0.0), lower, steps);
  const std::vector<dvec2> section = ellipse(0.055, 0.085, 6);
  std::vector<Ring> rings;
  for (const Frame& frame : frames_along(curve, dvec3(0.0, 1.0, 0.0))) {
    const double t = static_cast<double>(rings.size()) / steps;
    rings.push_back(section_ring(frame, section, 1.0 + 0.3 * std::pow(2.0 * t - 1.0, 4.0)));
  }
  return rings;
}

}  // namespace

Mesh make_teacup(int segments) {
  assert(segments >= 8);
  std::vector<ProfilePoint> profile(outside.begin(), outside.end());
  profile.insert(profile.end(), inside.begin(), inside.end());
  Mesh mesh;
  // A facet, not an edge, faces the handle.
  append_rings(mesh, lathe(profile, segments, std::numbers::pi / segments));
  append_rings(mesh, handle(segments));
  set_smooth_normals(mesh, crease_degrees);
  mesh.materials.push_back(glaze("glaze", {0.86, 0.83, 0.76}));
  return mesh;
}

}  // namespace collage
