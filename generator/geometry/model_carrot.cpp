#include <array>
#include <cmath>
#include <numbers>

#include "geometry/frames.h"
#include "geometry/mesh_parts.h"
#include "geometry/model_materials.h"
#include "geometry/models.h"
#include "geometry/smooth_normals.h"
#include "geometry/sweep.h"

namespace collage {
namespace {

/// From the tip to the bottom of the dimple in the crown.
constexpr std::array<ProfilePoint, 9> root_profile = {{{0.0, 0.0},
                                                       {0.05, 0.17},
                                                       {0.155, 0.72},
                                                       {0.235, 1.16},
                                                       {0.325, 1.57},
                                                       {0.385, 1.93},
                                                       {0.33, 2.13},
                                                       {0.17, 2.17},
                                                       {0.0, 2.1}}};

/// Roots grow a little crooked and not quite round.
dvec3 grown(const dvec3& p) {
  const double angle = std::atan2(p.z, p.x);
  const double girth =
      1.0 + 0.05 * std::sin(2.0 * angle + 2.1 * p.y) + 0.03 * std::sin(3.0 * angle - 4.7 * p.y);
  const double lean = 0.05 * std::pow(2.2 - p.y, 2.0) - 0.03 * std::sin(2.6 * p.y);
  return {girth * p.x + lean, p.y, girth * p.z - 0.4 * lean};
}

struct Frond {
  double azimuth_degrees;
  double reach;
  double height;
};
constexpr std::array<Frond, 5> fronds = {{{5.0, 0.75, 0.85},
                                          {80.0, 0.5, 1.15},
                                          {150.0, 0.8, 0.95},
                                          {222.0, 0.42, 1.3},
                                          {295.0, 0.66, 1.05}}};

/// Half the frond's width from its foot to its tip: a stalk, then leaflets in pairs.
constexpr std::array half_widths = {0.034, 0.028, 0.19, 0.07, 0.2, 0.055, 0.0};

/// A frond with a ridge along its upper side; its leaflets point to the tip.
Mesh make_frond(const Frond& frond) {
  const double azimuth = glm::radians(frond.azimuth_degrees);
  const dvec3 out(std::cos(azimuth), 0.0, -std::sin(azimuth));
  const dvec3 foot = 0.09 * out + dvec3(0.0, 2.185, 0.0);
  const dvec3 tip = foot + frond.reach * out + dvec3(0.0, frond.height, 0.0);
  const auto curve =
      bezier_curve(foot, foot + dvec3(0.0, 0.55 * frond.height, 0.0),
                   tip - 0.45 * frond.reach * out, tip, static_cast<int>(half_widths.size()) - 1);
  const std::vector<Frame> frames = frames_along(curve, out);
  std::vector<Ring> rings;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const double w = half_widths[i];
    const double ridge = w > 0.0 ? 0.022 : 0.0;
    const dvec3 forward = 0.7 * glm::max(0.0, w - 0.06) * frames[i].along;
    rings.push_back({frames[i].point({-ridge, 0.0}), frames[i].point({ridge, -w}) + forward,
                     frames[i].point({ridge, w}) + forward});
  }
  Mesh mesh;
  append_rings(mesh, rings);
  return mesh;
}

}  // namespace

Mesh make_carrot() {
  Mesh root;
  append_rings(root, lathe(root_profile, 8, 0.0));
  deform(root, grown);
  Mesh mesh;
  append_part(mesh, root, carrot_skin());
  for (const Frond& frond : fronds) {
    append_part(mesh, make_frond(frond), greens());
  }
  set_smooth_normals(mesh, 80.0);
  return mesh;
}

}  // namespace collage
