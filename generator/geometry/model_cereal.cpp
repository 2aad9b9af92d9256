#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "geometry/extrusion.h"
#include "geometry/mesh_parts.h"
#include "geometry/model_materials.h"
#include "geometry/models.h"
#include "geometry/subdivision.h"
#include "geometry/sweep.h"

namespace collage {
namespace {

using std::cos;
using std::sin;

constexpr double full_turn = 2.0 * std::numbers::pi;

/// A ring round the y axis: `section` at each angle across its middle line.
Mesh torus(int segments, const std::function<Frame(double angle)>& middle_line,
           const std::function<std::vector<dvec2>(double angle)>& section) {
  std::vector<Ring> rings;
  for (int i = 0; i < segments; ++i) {
    const double angle = full_turn * i / segments;
    rings.push_back(section_ring(middle_line(angle), section(angle)));
  }
  Mesh mesh;
  append_ring_loop(mesh, rings);
  return mesh;
}

/// The frame across a circle round the y axis, with u outwards and v down.
Frame across_circle(double angle, double radius, double height) {
  const dvec3 out(cos(angle), 0.0, -sin(angle));
  return {radius * out + dvec3(0.0, height, 0.0), dvec3(out.z, 0.0, -out.x), out,
          dvec3(0.0, -1.0, 0.0)};
}

Mesh baked(const Mesh& dough, const dvec3& color) {
  return make_model(dough, cereal(color), all_smooth_degrees);
}

}  // namespace

Mesh make_cereal_ring() {
  const auto middle_line = [](double angle) {
    return across_circle(angle, 0.52 + 0.02 * sin(3.0 * angle), 0.02 * sin(2.0 * angle + 1.0));
  };
  const auto section = [](double angle) {
    const double girth = 0.25 + 0.018 * sin(5.0 * angle + 0.7) + 0.012 * cos(2.0 * angle);
    return ellipse(girth, 1.05 * girth, 6);
  };
  return baked(torus(20, middle_line, section), {0.58, 0.31, 0.09});
}

Mesh make_cereal_loop() {
  const auto middle_line = [](double angle) {
    return across_circle(angle, 0.78 + 0.05 * cos(2.0 * angle) + 0.02 * sin(3.0 * angle),
                         0.09 * sin(2.0 * angle + 0.5));
  };
  const auto section = [](double angle) {
    const double girth = 0.2 + 0.014 * sin(4.0 * angle);
    return ellipse(girth, 1.2 * girth, 6, 0.3);
  };
  return baked(torus(20, middle_line, section), {0.62, 0.075, 0.13});
}

Mesh make_cereal_flake() {
  constexpr int corners = 20;
  constexpr double half_thickness = 0.045;
  /// Curled across x and twisted a little, with blisters.
  const auto at = [](double angle, double part, double side) {
    const double rim = 1.0 + 0.13 * sin(3.0 * angle + 0.4) + 0.08 * sin(5.0 * angle + 2.0) +
                       0.05 * cos(8.0 * angle);
    const double x = 0.92 * part * rim * cos(angle);
    const double z = -1.15 * part * rim * sin(angle);
    const double y = 0.62 * x * x - 0.12 * z * z + 0.25 * x * z +
                     0.09 * sin(4.5 * x + 1.0) * cos(4.0 * z) + side * half_thickness;
    return dvec3(x, y, z);
  };
  /// Parts of the way to the rim, below and above.
  constexpr std::array<dvec2, 6> profile = {
      {{0.0, -1.0}, {0.55, -1.0}, {0.97, -0.8}, {0.97, 0.8}, {0.55, 1.0}, {0.0, 1.0}}};
  std::vector<Ring> rings;
  for (const dvec2& at_rim : profile) {
    Ring& ring = rings.emplace_back();
    for (int i = 0; i < corners; ++i) {
      ring.push_back(at(full_turn * i / corners, at_rim.x, at_rim.y));
    }
  }
  Mesh flake;
  append_rings(flake, rings);
  return baked(flake, {0.72, 0.36, 0.06});
}

Mesh make_cereal_star() {
  std::vector<dvec2> outline;
  for (int i = 0; i < 10; ++i) {
    const double angle = full_turn * i / 10 + 0.25 * full_turn;
    const double radius = i % 2 == 0 ? 1.6 : 0.72;
    outline.emplace_back(radius * cos(angle), radius * sin(angle));
  }
  Mesh star = triangulated(catmull_clark(extrude(outline, 0.8, 0.4)));
  deform(star, [](const dvec3& p) { return dvec3(p.x, p.z, -p.y); });
  return baked(star, {0.82, 0.56, 0.20});
}

Mesh make_cereal_puff() {
  constexpr int segments = 12;
  constexpr int bands = 11;
  std::vector<ProfilePoint> profile;
  for (int i = 0; i <= bands; ++i) {
    const double angle = std::numbers::pi * i / bands;
    profile.emplace_back(i % bands == 0 ? 0.0 : 0.62 * sin(angle), -0.62 * cos(angle));
  }
  Mesh puff;
  append_rings(puff, lathe(profile, segments, 0.0));
  deform(puff, [](const dvec3& p) {
    const double lumps = 1.0 + 0.08 * sin(6.0 * p.x + 1.0) * cos(5.0 * p.z) +
                         0.07 * sin(6.0 * p.y + 2.0) * cos(5.0 * p.x - 1.0) +
                         0.04 * sin(7.0 * p.z - 3.0 * p.y);
    return lumps * dvec3(1.06 * p.x, 0.95 * p.y, p.z);
  });
  return baked(puff, {0.27, 0.115, 0.045});
}

}  // namespace collage
