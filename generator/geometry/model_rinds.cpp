#include <numeric>
#include <vector>

#include "geometry/extrusion.h"
#include "geometry/mesh_parts.h"
#include "geometry/model_materials.h"
#include "geometry/models.h"
#include "geometry/polyhedra.h"
#include "geometry/rind.h"
#include "geometry/smooth_normals.h"
#include "geometry/subdivision.h"

namespace collage {
namespace {

/// The rind of a polyhedron, with a window of `width` times the face in each face.
PolygonMesh windowed(PolygonMesh shape, double width, double thickness) {
  std::vector<std::uint32_t> windows(shape.faces.size());
  std::iota(windows.begin(), windows.end(), 0U);
  for (const std::uint32_t window : windows) {
    extrude_face(shape, window, dvec3(0.0), width);
  }
  return rind(shape, thickness, windows);
}

Mesh lacquered(const PolygonMesh& shape, const dvec3& color) {
  Mesh mesh;
  append_part(mesh, triangulated(shape), lacquer(color));
  fit_unit_sphere(mesh);
  set_smooth_normals(mesh, 85.0);
  return mesh;
}

}  // namespace

Mesh make_rind_tetrahedron() {
  return lacquered(doo_sabin(windowed(regular_tetrahedron(), 0.5, 0.13)), {0.02, 0.21, 0.28});
}
Mesh make_rind_prism() {
  return lacquered(doo_sabin(windowed(regular_prism(3), 0.58, 0.135)), {0.02, 0.21, 0.28});
}
Mesh make_rind_octahedron() {
  PolygonMesh shape = regular_octahedron();
  // Every other face: no two with an edge in common.
  std::vector<std::uint32_t> windows;
  for (std::uint32_t f = 0; f < 8; ++f) {
    const dvec3 normal = face_normal(shape, f);
    if (normal.x * normal.y * normal.z > 0.0) {
      windows.push_back(f);
      extrude_face(shape, f, dvec3(0.0), 0.75);
    }
  }
  return lacquered(doo_sabin(rind(shape, 0.15, windows)), {0.02, 0.21, 0.28});
}

Mesh make_rind_target() {
  return lacquered(catmull_clark(catmull_clark(windowed(regular_dodecahedron(), 0.6, 0.3))),
                   {0.02, 0.21, 0.28});
}

}  // namespace collage
