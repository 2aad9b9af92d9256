#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "geometry/mesh_parts.h"
#include "geometry/model_materials.h"
#include "geometry/models.h"
#include "geometry/sweep.h"

namespace collage {
namespace {

constexpr double full_turn = 2.0 * std::numbers::pi;
constexpr dvec3 wine(0.33, 0.02, 0.06);
constexpr dvec3 ivory(0.75, 0.70, 0.60);

/// Hoops on great circles of the unit sphere.
struct Weave {
  /// How often each hoop crosses others, at equal distances.
  int crossings;
  int segments;
  /// Along the sphere, and across it.
  double half_width;
  double half_thickness;
  /// How far over and under the sphere a hoop runs where it crosses others.
  double rise;
  int section_corners;
};

/// The point of the great circle across `axis` at an angle from `start`.
dvec3 on_circle(const dvec3& axis, const dvec3& start, double angle) {
  return std::cos(angle) * start + std::sin(angle) * glm::cross(axis, start);
}

/// 1 where a hoop that is over at its start is over, -1 where it is under.
double height(const Weave& weave, double angle) { return std::cos(0.5 * weave.crossings * angle); }

/// Adds a hoop that is over at `start`.
void append_hoop(Mesh& mesh, const dvec3& axis, const dvec3& start, const Weave& weave) {
  const std::vector<dvec2> section =
      ellipse(weave.half_thickness, weave.half_width, weave.section_corners,
              std::numbers::pi / weave.section_corners);
  std::vector<Ring> rings;
  for (int i = 0; i < weave.segments; ++i) {
    const double angle = full_turn * i / weave.segments;
    const dvec3 out = on_circle(axis, start, angle);
    const dvec3 along = glm::cross(axis, out);
    const dvec3 middle = (1.0 + weave.rise * height(weave, angle)) * out;
    rings.push_back(section_ring({middle, along, out, -axis}, section));
  }
  append_ring_loop(mesh, rings);
}

/// Hoops across all axes, each over where the other is under.
Mesh make_woven(std::span<const dvec3> axes, const Weave& weave, const dvec3& color) {
  const dvec3 first_start = glm::normalize(glm::cross(axes[0], axes[1]));
  Mesh hoops;
  append_hoop(hoops, axes[0], first_start, weave);
  for (const dvec3& axis : axes.subspan(1)) {
    const dvec3 crossing = glm::normalize(glm::cross(axes[0], axis));
    const double turn = std::atan2(glm::dot(glm::cross(first_start, crossing), axes[0]),
                                   glm::dot(first_start, crossing));
    const bool first_is_over = height(weave, turn) > 0.0;
    const dvec3 next_crossing = on_circle(axis, crossing, full_turn / weave.crossings);
    const dvec3 start = first_is_over ? next_crossing : crossing;
    append_hoop(hoops, axis, start, weave);
  }
  return make_model(in_unit_sphere(hoops), lacquer(color), 60.0);
}

/// The trefoil as the torus knot that goes twice round the y axis and three times round the tube.
dvec3 trefoil(double angle) {
  const double radius = 1.0 + 0.52 * std::cos(3.0 * angle);
  return {radius * std::cos(2.0 * angle), 0.6 * std::sin(3.0 * angle),
          -radius * std::sin(2.0 * angle)};
}

}  // namespace

Mesh make_woven_octahedron() {
  constexpr std::array<dvec3, 3> axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  return make_woven(axes,
                    {.crossings = 4,
                     .segments = 20,
                     .half_width = 0.2,
                     .half_thickness = 0.09,
                     .rise = 0.14,
                     .section_corners = 4},
                    wine);
}

Mesh make_woven_cuboctahedron() {
  const double s = std::sqrt(1.0 / 3.0);
  const std::array<dvec3, 4> axes = {{{s, s, s}, {s, -s, -s}, {-s, s, -s}, {-s, -s, s}}};
  return make_woven(axes,
                    {.crossings = 6,
                     .segments = 18,
                     .half_width = 0.14,
                     .half_thickness = 0.1,
                     .rise = 0.13,
                     .section_corners = 3},
                    ivory);
}

Mesh make_trefoil() {
  constexpr int segments = 40;
  const std::vector<dvec2> section = ellipse(0.27, 0.27, 6);
  std::vector<Ring> rings;
  for (int i = 0; i < segments; ++i) {
    const double angle = full_turn * i / segments;
    const dvec3 here = trefoil(angle);
    const dvec3 along = glm::normalize(trefoil(angle + 1e-4) - trefoil(angle - 1e-4));
    // Away from the middle of the torus's tube: sections turn with the knot and close.
    const dvec3 out = here - glm::normalize(dvec3(here.x, 0.0, here.z));
    const dvec3 u = glm::normalize(out - glm::dot(out, along) * along);
    rings.push_back(section_ring({here, along, u, glm::cross(along, u)}, section));
  }
  Mesh knot;
  append_ring_loop(knot, rings);
  return make_model(in_unit_sphere(knot), lacquer(ivory), all_smooth_degrees);
}

Mesh make_woven_target() {
  // The great circles of the icosidodecahedron.
  std::vector<dvec3> axes;
  for (const double phi : {-std::numbers::phi, std::numbers::phi}) {
    for (const dvec3& axis : {dvec3(0, 1, phi), dvec3(1, phi, 0), dvec3(phi, 0, 1)}) {
      axes.push_back(glm::normalize(axis));
    }
  }
  return make_woven(axes,
                    {.crossings = 10,
                     .segments = 60,
                     .half_width = 0.165,
                     .half_thickness = 0.12,
                     .rise = 0.18,
                     .section_corners = 8},
                    wine);
}

}  // namespace collage
