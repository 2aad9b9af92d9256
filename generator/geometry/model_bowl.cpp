#include <array>
#include <cmath>
#include <vector>

#include <glm/gtc/constants.hpp>

#include "geometry/mesh_parts.h"
#include "geometry/model_materials.h"
#include "geometry/models.h"
#include "geometry/smooth_normals.h"
#include "geometry/sweep.h"

namespace collage {
namespace {

constexpr int segments = 48;
constexpr int bowl_segments = 90;
/// Turned a little, so that no view from a whole number of degrees looks along edges.
constexpr double bowl_phase = 0.4 * glm::two_pi<double>() / bowl_segments;
constexpr double rim_height = 6.2;

/// The wall inside, from the middle of the bottom to the rim, in centimetres.
constexpr std::array<ProfilePoint, 7> inside = {
    {{0.0, 1.0}, {2.2, 1.1}, {4.1, 1.6}, {5.6, 2.55}, {6.65, 3.8}, {7.3, 5.1}, {7.6, 6.12}}};
/// From the middle of the underside up to the rim.
constexpr std::array<ProfilePoint, 10> outside = {{{0.0, 0.35},
                                                   {2.8, 0.3},
                                                   {3.0, 0.0},
                                                   {3.4, 0.0},
                                                   {3.55, 0.55},
                                                   {5.0, 1.3},
                                                   {6.3, 2.5},
                                                   {7.25, 3.9},
                                                   {7.75, 5.2},
                                                   {8.0, 6.1}}};

}  // namespace

Mesh make_bowl() {
  std::vector<ProfilePoint> profile(outside.begin(), outside.end());
  profile.emplace_back(7.82, rim_height);
  profile.insert(profile.end(), inside.rbegin(), inside.rend());
  Mesh clay;
  append_rings(clay, lathe(profile, bowl_segments, bowl_phase));
  Mesh mesh;
  append_part(mesh, clay, glaze("glaze", {0.86, 0.83, 0.76}));
  // From above the foot to the rim.
  paint(mesh, glaze("blue-glaze", {0.035, 0.12, 0.24}), band_start(4, bowl_segments),
        band_start(outside.size() - 1, bowl_segments));
  set_smooth_normals(mesh, 40.0);
  return mesh;
}

Mesh make_bowl_inside() {
  constexpr double gap = 0.12;
  std::vector<ProfilePoint> profile;
  for (const ProfilePoint& point : inside) {
    profile.emplace_back(glm::max(0.0, point.x - gap), point.y + gap);
  }
  // The heap: part of a sphere on the edge of the wall.
  constexpr double dome = 1.5;
  constexpr int steps = 5;
  const ProfilePoint edge = profile.back();
  const double radius = (edge.x * edge.x + dome * dome) / (2.0 * dome);
  const double half_angle = std::asin(edge.x / radius);
  for (int i = 1; i <= steps; ++i) {
    const double angle = half_angle * (steps - i) / steps;
    profile.emplace_back(radius * std::sin(angle),
                         edge.y + dome - radius * (1.0 - std::cos(angle)));
  }
  Mesh space;
  append_rings(space, lathe(profile, segments, 0.0));
  return make_model(space, milk(), 40.0);
}

Mesh make_bowl_milk() {
  constexpr double overlap = 0.05;  // with the wall, so that no gap shows
  std::vector<ProfilePoint> profile;
  for (const ProfilePoint& point : inside) {
    profile.emplace_back(point.x > 0.0 ? point.x + overlap : 0.0, point.y - overlap);
  }
  // Between the last two points of the wall.
  constexpr double level = 0.6;
  profile.back() = glm::mix(profile[profile.size() - 2], profile.back(), level);
  profile.emplace_back(0.0, profile.back().y);
  Mesh body;
  append_rings(body, lathe(profile, bowl_segments, bowl_phase));
  return make_model(body, milk(), 40.0);
}

}  // namespace collage
