#include <array>
#include <numbers>
#include <utility>
#include <vector>

#include "geometry/handles.h"
#include "geometry/mesh_parts.h"
#include "geometry/model_materials.h"
#include "geometry/models.h"
#include "geometry/polyhedra.h"
#include "geometry/subdivision.h"

namespace collage {
namespace {

constexpr dvec3 vermilion(0.62, 0.12, 0.045);
constexpr dvec3 amber(0.80, 0.42, 0.07);

Mesh lacquered(const PolygonMesh& shape, const dvec3& color) {
  return make_model(in_unit_sphere(triangulated(shape)), lacquer(color), all_smooth_degrees);
}

}  // namespace

Mesh make_handled_cube() {
  const PolygonMesh cube = regular_cube();
  const std::array<FacePair, 3> pairs = {
      {{face_towards(cube, {1, 0, 0}), face_towards(cube, {0, 1, 0})},
       {face_towards(cube, {0, 0, 1}), face_towards(cube, {-1, 0, 0})},
       {face_towards(cube, {0, -1, 0}), face_towards(cube, {0, 0, -1})}}};
  return lacquered(doo_sabin(with_handles(cube, pairs, {.steps = 4, .reach = 2.1, .waist = 0.5})),
                   vermilion);
}

Mesh make_handled_octahedron() {
  const PolygonMesh shape = regular_octahedron();
  std::vector<FacePair> pairs;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      pairs.push_back({face_towards(shape, {x, y, 1}), face_towards(shape, {x, y, -1})});
    }
  }
  return lacquered(doo_sabin(with_handles(shape, pairs, {.steps = 4, .reach = 2.0, .waist = 0.6})),
                   amber);
}

Mesh make_handled_tetrahedron() {
  const std::array<FacePair, 2> pairs = {{{0, 1}, {2, 3}}};
  return lacquered(doo_sabin(with_handles(regular_tetrahedron(), pairs,
                                          {.steps = 6, .reach = 3.4, .waist = 0.45, .twist = 1})),
                   amber);
}

Mesh make_handled_target() {
  const PolygonMesh shape = regular_dodecahedron();
  // The faces of a dodecahedron lie towards the corners of three rectangles; each handle spans one
  // of their short sides.
  std::vector<FacePair> pairs;
  for (const double far : {-std::numbers::phi, std::numbers::phi}) {
    for (const auto& [a, b] : {std::pair(dvec3(far, 1, 0), dvec3(far, -1, 0)),
                               std::pair(dvec3(0, far, 1), dvec3(0, far, -1)),
                               std::pair(dvec3(1, 0, far), dvec3(-1, 0, far))}) {
      pairs.push_back({face_towards(shape, a), face_towards(shape, b)});
    }
  }
  const PolygonMesh handled = with_handles(shape, pairs, {.steps = 6, .reach = 1.9, .waist = 0.75});
  return lacquered(doo_sabin(doo_sabin(handled)), vermilion);
}

}  // namespace collage
