#include <numeric>
#include <vector>

#include "geometry/extrusion.h"
#include "geometry/mesh_parts.h"
#include "geometry/model_materials.h"
#include "geometry/models.h"
#include "geometry/polyhedra.h"
#include "geometry/rind.h"
#include "geometry/subdivision.h"

namespace collage {
namespace {

constexpr dvec3 teal(0.02, 0.21, 0.28);
constexpr dvec3 ice(0.42, 0.60, 0.64);
constexpr dvec3 navy(0.02, 0.055, 0.15);

/// The rind of a polyhedron in which each face of `windows` has a window of `width` times its size.
PolygonMesh windowed(PolygonMesh shape, const std::vector<std::uint32_t>& windows, double width,
                     double thickness) {
  for (const std::uint32_t window : windows) {
    extrude_face(shape, window, dvec3(0.0), width);
  }
  return rind(shape, thickness, windows);
}

std::vector<std::uint32_t> all_faces(const PolygonMesh& shape) {
  std::vector<std::uint32_t> faces(shape.faces.size());
  std::iota(faces.begin(), faces.end(), 0U);
  return faces;
}

Mesh lacquered(const PolygonMesh& shape, const dvec3& color) {
  return make_model(in_unit_sphere(triangulated(shape)), lacquer(color), all_smooth_degrees);
}

}  // namespace

Mesh make_rind_tetrahedron() {
  const PolygonMesh shape = regular_tetrahedron();
  return lacquered(doo_sabin(windowed(shape, all_faces(shape), 0.5, 0.13)), teal);
}

Mesh make_rind_prism() {
  const PolygonMesh shape = regular_prism(3);
  return lacquered(doo_sabin(windowed(shape, all_faces(shape), 0.58, 0.135)), ice);
}

Mesh make_rind_octahedron() {
  const PolygonMesh shape = regular_octahedron();
  std::vector<std::uint32_t> every_other;
  for (const std::uint32_t face : all_faces(shape)) {
    const dvec3 normal = face_normal(shape, face);
    if (normal.x * normal.y * normal.z > 0.0) {
      every_other.push_back(face);
    }
  }
  return lacquered(doo_sabin(windowed(shape, every_other, 0.75, 0.15)), navy);
}

Mesh make_rind_target() {
  const PolygonMesh shape = regular_dodecahedron();
  return lacquered(catmull_clark(catmull_clark(windowed(shape, all_faces(shape), 0.6, 0.3))), teal);
}

}  // namespace collage
