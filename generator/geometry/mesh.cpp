#include "geometry/mesh.h"

namespace collage {

Box bounding_box(const Mesh& mesh) {
  Box box;
  for (const uvec3& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      box.include(mesh.positions[t[k]]);
    }
  }
  return box;
}

double enclosed_volume(const Mesh& mesh) {
  if (mesh.triangles.empty()) {
    return 0.0;
  }
  const dvec3 origin = bounding_box(mesh).center();  // near the mesh, so that nothing cancels
  double sum = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const dvec3 a = mesh.corner(t, 0) - origin;
    const dvec3 b = mesh.corner(t, 1) - origin;
    const dvec3 c = mesh.corner(t, 2) - origin;
    sum += glm::dot(a, glm::cross(b, c));
  }
  return sum / 6.0;
}

double surface_area(const Mesh& mesh) {
  double sum = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const dvec3 a = mesh.corner(t, 0);
    sum += 0.5 * glm::length(glm::cross(mesh.corner(t, 1) - a, mesh.corner(t, 2) - a));
  }
  return sum;
}

void reverse_orientation(Mesh& mesh) {
  for (auto* triangles : {&mesh.triangles, &mesh.normal_triangles, &mesh.uv_triangles}) {
    for (uvec3& t : *triangles) {
      std::swap(t.y, t.z);
    }
  }
  for (dvec3& normal : mesh.normals) {
    normal = -normal;
  }
}

}  // namespace collage
