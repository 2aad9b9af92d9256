#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "geometry/mesh_parts.h"
#include "geometry/model_materials.h"
#include "geometry/models.h"
#include "geometry/smooth_normals.h"
#include "geometry/sweep.h"

namespace collage {
namespace {

constexpr double full_turn = 2.0 * std::numbers::pi;

struct Weave {
  int segments;
  /// Half the hoops' width, along the sphere, and half their thickness, across it.
  double half_width;
  double half_thickness;
  /// How far over and under the sphere they run where they cross.
  double rise;
  int section_corners;
};

/// The great circle across an axis, from `start` on.
dvec3 on_circle(const dvec3& axis, const dvec3& start, double angle) {
  return std::cos(angle) * start + std::sin(angle) * glm::cross(axis, start);
}

/// A hoop that swings between over and under, from over at `start` through `crossings` crossings.
Mesh hoop(const dvec3& axis, const dvec3& start, int crossings, const Weave& weave) {
  const std::vector<dvec2> section =
      ellipse(weave.half_thickness, weave.half_width, weave.section_corners,
              std::numbers::pi / weave.section_corners);
  std::vector<Ring> rings;
  for (int i = 0; i < weave.segments; ++i) {
    const double angle = full_turn * i / weave.segments;
    const dvec3 out = on_circle(axis, start, angle);
    const dvec3 along = glm::cross(axis, out);
    const double radius = 1.0 + weave.rise * std::cos(0.5 * crossings * angle);
    rings.push_back(section_ring({radius * out, along, out, glm::cross(along, out)}, section));
  }
  Mesh mesh;
  append_ring_loop(mesh, rings);
  return mesh;
}

/// Hoops across all axes. Each is `over` where its start says so; of two hoops that cross one must
/// be over and one under.
Mesh woven(std::span<const dvec3> axes, int crossings, const Weave& weave, const dvec3& color) {
  Mesh mesh;
  std::vector<dvec3> starts;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    // Where it crosses the first hoop, under that; the first begins over where the second is.
    const dvec3 other = i == 0 ? axes[1] : axes[0];
    dvec3 start = glm::normalize(glm::cross(axes[i], other));
    if (i > 0) {
      const dvec3 axis = axes[0];
      const double turn =
          std::atan2(glm::dot(glm::cross(starts[0], start), axis), glm::dot(starts[0], start));
      const bool first_is_over = std::cos(0.5 * crossings * turn) > 0.0;
      if (first_is_over) {
        start = on_circle(axes[i], start, full_turn / crossings);
      }
    }
    starts.push_back(start);
    append_part(mesh, hoop(axes[i], start, crossings, weave), lacquer(color));
  }
  fit_unit_sphere(mesh);
  set_smooth_normals(mesh, 60.0);
  return mesh;
}

/// The trefoil as the torus knot that goes round the y axis twice and round the tube three times.
dvec3 trefoil(double angle) {
  const double radius = 1.0 + 0.52 * std::cos(3.0 * angle);
  return {radius * std::cos(2.0 * angle), 0.6 * std::sin(3.0 * angle),
          -radius * std::sin(2.0 * angle)};
}

}  // namespace

Mesh make_woven_octahedron() {
  const std::array<dvec3, 3> axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  return woven(axes, 4, {20, 0.2, 0.09, 0.14, 4}, {0.33, 0.02, 0.06});
}

Mesh make_woven_cuboctahedron() {
  std::vector<dvec3> axes;
  for (const dvec3& axis : {dvec3(1, 1, 1), dvec3(1, -1, -1), dvec3(-1, 1, -1), dvec3(-1, -1, 1)}) {
    axes.push_back(glm::normalize(axis));
  }
  return woven(axes, 6, {18, 0.14, 0.1, 0.13, 3}, {0.75, 0.70, 0.60});
}

Mesh make_woven_target() {
  constexpr double phi = std::numbers::phi;
  std::vector<dvec3> axes;
  for (const double sign : {-1.0, 1.0}) {
    for (const dvec3& axis : {dvec3(0, sign, phi), dvec3(sign, phi, 0), dvec3(phi, 0, sign)}) {
      axes.push_back(glm::normalize(axis));
    }
  }
  return woven(axes, 10, {60, 0.165, 0.12, 0.18, 8}, {0.33, 0.02, 0.06});
}

Mesh make_trefoil() {
  constexpr int segments = 40;
  const std::vector<dvec2> section = ellipse(0.27, 0.27, 6);
  std::vector<Ring> rings;
  for (int i = 0; i < segments; ++i) {
    const double angle = full_turn * i / segments;
    const dvec3 here = trefoil(angle);
    const dvec3 along = glm::normalize(trefoil(angle + 1e-4) - trefoil(angle - 1e-4));
    // Sections stand on the torus on which the knot lies.
    const dvec3 spoke = here - glm::normalize(dvec3(here.x, 0.0, here.z));
    const dvec3 u = glm::normalize(spoke - glm::dot(spoke, along) * along);
    rings.push_back(section_ring({here, along, u, glm::cross(along, u)}, section));
  }
  Mesh knot;
  append_ring_loop(knot, rings);
  Mesh mesh;
  append_part(mesh, knot, lacquer({0.75, 0.70, 0.60}));
  fit_unit_sphere(mesh);
  set_smooth_normals(mesh, 85.0);
  return mesh;
}

}  // namespace collage
