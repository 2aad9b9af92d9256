#include <array>
#include <vector>

#include "geometry/extrusion.h"
#include "geometry/handles.h"
#include "geometry/mesh_parts.h"
#include "geometry/model_materials.h"
#include "geometry/models.h"
#include "geometry/polyhedra.h"
#include "geometry/smooth_normals.h"
#include "geometry/subdivision.h"

namespace collage {
namespace {

/// The face whose normal is nearest to a direction.
std::uint32_t face_towards(const PolygonMesh& mesh, const dvec3& direction) {
  std::uint32_t best = 0;
  for (std::uint32_t f = 1; f < mesh.faces.size(); ++f) {
    if (glm::dot(face_normal(mesh, f), direction) > glm::dot(face_normal(mesh, best), direction)) {
      best = f;
    }
  }
  return best;
}

Mesh lacquered(const PolygonMesh& shape, const dvec3& color) {
  Mesh mesh;
  append_part(mesh, triangulated(shape), lacquer(color));
  fit_unit_sphere(mesh);
  set_smooth_normals(mesh, 85.0);
  return mesh;
}

}  // namespace

Mesh make_handled_cube() {
  PolygonMesh cube = regular_cube();
  const std::array<FacePair, 3> pairs = {
      {{face_towards(cube, {1, 0, 0}), face_towards(cube, {0, 1, 0})},
       {face_towards(cube, {0, 0, 1}), face_towards(cube, {-1, 0, 0})},
       {face_towards(cube, {0, -1, 0}), face_towards(cube, {0, 0, -1})}}};
  return lacquered(doo_sabin(with_handles(cube, pairs, {.steps = 4, .reach = 2.1, .waist = 0.5})),
                   {0.62, 0.12, 0.045});
}

Mesh make_handled_octahedron() {
  PolygonMesh shape = regular_octahedron();
  std::vector<FacePair> pairs;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      pairs.push_back({face_towards(shape, {x, y, 1}), face_towards(shape, {x, y, -1})});
    }
  }
  return lacquered(doo_sabin(with_handles(shape, pairs, {.steps = 4, .reach = 2.0, .waist = 0.6})),
                   {0.80, 0.42, 0.07});
}

Mesh make_handled_tetrahedron() {
  const std::array<FacePair, 2> pairs = {{{0, 1}, {2, 3}}};
  return lacquered(doo_sabin(with_handles(regular_tetrahedron(), pairs,
                                          {.steps = 6, .reach = 2.6, .waist = 0.55})),
                   {0.80, 0.42, 0.07});
}

Mesh make_handled_target() {
  PolygonMesh shape = regular_dodecahedron();
  std::vector<FacePair> pairs;
  constexpr double phi = std::numbers::phi;
  for (const double sign : {-1.0, 1.0}) {
    pairs.push_back(
        {face_towards(shape, {sign * phi, 1, 0}), face_towards(shape, {sign * phi, -1, 0})});
    pairs.push_back(
        {face_towards(shape, {0, sign * phi, 1}), face_towards(shape, {0, sign * phi, -1})});
    pairs.push_back(
        {face_towards(shape, {1, 0, sign * phi}), face_towards(shape, {-1, 0, sign * phi})});
  }
  return lacquered(
      doo_sabin(doo_sabin(with_handles(shape, pairs, {.steps = 6, .reach = 1.9, .waist = 0.75}))),
      {0.62, 0.12, 0.045});
}

}  // namespace collage
