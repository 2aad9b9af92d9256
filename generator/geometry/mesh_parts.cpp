#include "geometry/mesh_parts.h"

#include <algorithm>

#include "geometry/bounding_sphere.h"
#include "geometry/smooth_normals.h"

namespace collage {
namespace {

/// The number of a material of that name, which is added where there is none.
std::uint32_t material_number(Mesh& mesh, const Material& material) {
  const auto known = std::find_if(mesh.materials.begin(), mesh.materials.end(),
                                  [&](const Material& m) { return m.name == material.name; });
  const auto number = static_cast<std::uint32_t>(known - mesh.materials.begin());
  if (known == mesh.materials.end()) {
    mesh.materials.push_back(material);
  }
  return number;
}

}  // namespace

void append_part(Mesh& mesh, const Mesh& part, const Material& material) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
  for (const uvec3& triangle : part.triangles) {
    mesh.triangles.push_back(triangle + uvec3(first));
  }
  mesh.triangle_materials.resize(mesh.triangles.size(), material_number(mesh, material));
}

void paint(Mesh& mesh, const Material& material, std::size_t first, std::size_t end) {
  const std::uint32_t number = material_number(mesh, material);
  mesh.triangle_materials.resize(mesh.triangles.size(), 0);
  std::fill(mesh.triangle_materials.begin() + static_cast<std::ptrdiff_t>(first),
            mesh.triangle_materials.begin() + static_cast<std::ptrdiff_t>(end), number);
}

void deform(Mesh& mesh, const std::function<dvec3(const dvec3&)>& moved) {
  std::transform(mesh.positions.begin(), mesh.positions.end(), mesh.positions.begin(),
                 [&](const dvec3& position) { return to_millionths(moved(position)); });
}

Mesh in_unit_sphere(Mesh mesh) {
  const Sphere sphere = smallest_enclosing_sphere(mesh.positions);
  deform(mesh, [&](const dvec3& position) { return (position - sphere.center) / sphere.radius; });
  return mesh;
}

Mesh make_model(const Mesh& shape, const Material& material, double crease_degrees) {
  Mesh mesh;
  append_part(mesh, shape, material);
  set_smooth_normals(mesh, crease_degrees);
  return mesh;
}

}  // namespace collage
