#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "geometry/cell_surface.h"
#include "geometry/extrusion.h"
#include "geometry/mesh_parts.h"
#include "geometry/model_materials.h"
#include "geometry/models.h"
#include "geometry/smooth_normals.h"
#include "geometry/subdivision.h"
#include "geometry/sweep.h"

namespace collage {
namespace {

/// Between a part and the next, which they must not touch: too little to be seen.
constexpr double joint = 0.002;

constexpr double seat_bottom = 0.86;
constexpr double seat_top = 0.95;

/// A turned stick: its radius at equally spaced points from one end to the other. The sections are
/// across `axis`, 0 for x, 1 for y, 2 for z, so that it ends flat against what is there.
Mesh stick(const dvec3& from, const dvec3& to, int axis, std::span<const double> radii) {
  Frame frame{from, dvec3(0.0), dvec3(0.0), dvec3(0.0)};
  const double way = to[axis] > from[axis] ? 1.0 : -1.0;
  frame.along[axis] = way;
  frame.u[(axis + 1) % 3] = 1.0;
  frame.v = glm::cross(frame.along, frame.u);
  const std::vector<dvec2> section = ellipse(1.0, 1.0, 6);
  std::vector<Ring> rings;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(radii.size() - 1);
    frame.origin = glm::mix(from, to, t);
    rings.push_back(section_ring(frame, section, radii[i]));
  }
  Mesh mesh;
  append_rings(mesh, rings);
  return mesh;
}

/// A square with round corners, a little narrower behind.
Mesh make_seat() {
  std::vector<dvec2> outline;
  constexpr int corners = 20;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + 0.5) / corners;
    const dvec2 way(std::cos(angle), std::sin(angle));
    const double radius =
        0.46 / std::pow(std::pow(std::abs(way.x), 4.5) + std::pow(std::abs(way.y), 4.5), 1.0 / 4.5);
    const dvec2 point = radius * way;
    outline.emplace_back(point.x * (1.0 - 0.16 * point.y), point.y);
  }
  Mesh seat = triangulated(extrude(outline, seat_top - seat_bottom, 0.022));
  // Drawn with the front at -y, laid down with the front at +z.
  deform(seat,
         [](const dvec3& p) { return dvec3(p.x, p.z + 0.5 * (seat_bottom + seat_top), -p.y); });
  return seat;
}

struct Leg {
  dvec3 foot;
  dvec3 top;

  [[nodiscard]] dvec3 at(double height) const {
    return glm::mix(foot, top, (height - foot.y) / (top.y - foot.y));
  }
};

Leg leg(double side, double front) {
  return {{side * 0.43, 0.0, front * 0.43},
          {side * (front > 0.0 ? 0.36 : 0.31), seat_bottom - joint, front * 0.33}};
}

constexpr std::array leg_radii = {0.022, 0.03, 0.038, 0.026, 0.04, 0.043, 0.04, 0.03, 0.026};
constexpr std::array stretcher_radii = {0.016, 0.021, 0.026, 0.021, 0.016};

void add_legs(Mesh& mesh) {
  constexpr double side_height = 0.34;
  constexpr double clearance = 0.039;  // from the middle of a leg
  std::array<dvec3, 2> side_middles;
  for (const int s : {0, 1}) {
    const double side = s == 0 ? -1.0 : 1.0;
    const Leg front = leg(side, 1.0);
    const Leg back = leg(side, -1.0);
    for (const Leg& each : {front, back}) {
      append_part(mesh, stick(each.foot, each.top, 1, leg_radii), wood());
    }
    const dvec3 a = back.at(side_height);
    const dvec3 b = front.at(side_height);
    const dvec3 way = clearance / (b.z - a.z) * (b - a);
    append_part(mesh, stick(a + way, b - way, 2, stretcher_radii), wood());
    side_middles[s] = 0.5 * (a + b);
  }
  const dvec3 way(stretcher_radii[2] + joint, 0.0, 0.0);
  append_part(mesh, stick(side_middles[0] + way, side_middles[1] - way, 0, stretcher_radii),
              wood());
}

constexpr double crest_bottom = 1.8;

/// Where the stick at -1 ≤ s ≤ 1 of the back ends under the crest, and the crest's middle line.
dvec3 crest_line(double s, double height) {
  return {0.44 * s, height + 0.03 * (1.0 - s * s), -0.56 - 0.08 * (1.0 - s * s)};
}

void add_back(Mesh& mesh) {
  constexpr std::array stile_radii = {0.022, 0.03, 0.028, 0.02};
  constexpr std::array spindle_radii = {0.012, 0.019, 0.011};
  constexpr int sticks = 7;
  for (int i = 0; i < sticks; ++i) {
    const double s = 2.0 * i / (sticks - 1) - 1.0;
    const dvec3 foot(0.35 * s, seat_top + joint, -0.34 - 0.03 * (1.0 - s * s));
    const dvec3 top = crest_line(0.93 * s, crest_bottom - 0.012);
    const bool is_stile = i == 0 || i == sticks - 1;
    append_part(mesh,
                is_stile ? stick(foot, top, 1, stile_radii) : stick(foot, top, 1, spindle_radii),
                wood());
  }
  constexpr int steps = 10;
  std::vector<Ring> rings;
  for (int i = 0; i <= steps; ++i) {
    const double s = 2.0 * i / steps - 1.0;
    const double height = 0.2 - 0.09 * s * s;
    const dvec3 base = crest_line(1.08 * s, crest_bottom);
    const dvec3 deep(0.0, 0.0, 0.03);
    const dvec3 up(0.0, height, -0.2 * height);
    rings.push_back({base + deep, base - deep, base - deep + 0.85 * up, base - 0.4 * deep + up,
                     base + 0.4 * deep + up, base + deep + 0.85 * up});
  }
  Mesh crest;
  append_rings(crest, rings);
  append_part(mesh, crest, wood());
}

}  // namespace

Mesh make_chair() {
  Mesh mesh;
  append_part(mesh, make_seat(), wood());
  add_legs(mesh);
  add_back(mesh);
  set_smooth_normals(mesh, 50.0);
  return mesh;
}

Mesh make_chair_target() {
  // Planes close to each other keep the edges between them firm when the whole is smoothed.
  constexpr std::array xs = {-0.54, -0.5, -0.3, 0.3, 0.5, 0.54};
  constexpr std::array ys = {0.0, 0.04, 0.5,  0.82, 0.86, 1.02, 1.06,
                             1.3, 1.46, 1.68, 1.84, 2.02, 2.07};
  constexpr std::array zs = {-0.54, -0.5, -0.3, 0.3, 0.5, 0.54};
  const auto is_solid = [](const dvec3& p) {
    const bool beside = std::abs(p.x) > 0.3;
    const bool in_front_or_behind = std::abs(p.z) > 0.3;
    const bool leg = p.y < 0.82 && beside && in_front_or_behind;
    const bool seat = p.y > 0.82 && p.y < 1.06;
    const bool in_slat = (p.y > 1.3 && p.y < 1.46) || p.y > 1.68;
    const bool back = p.y > 1.06 && p.z < -0.3 && (beside || in_slat);
    return leg || seat || back;
  };
  Mesh solid = triangulated(catmull_clark(cell_surface(xs, ys, zs, is_solid)));
  deform(solid, [](const dvec3& p) {
    const double lean = 0.2 * glm::max(0.0, p.y - 0.9);
    const double splay = 1.0 + 0.08 * glm::max(0.0, 0.9 - p.y);
    return dvec3(splay * p.x, p.y, splay * p.z - lean);
  });
  return make_model(solid, wood(), 50.0);
}

}  // namespace collage
