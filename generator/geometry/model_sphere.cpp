#include <algorithm>
#include <cassert>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "geometry/models.h"

namespace collage {
namespace {

Mesh make_icosahedron() {
  constexpr double golden = std::numbers::phi;
  Mesh mesh;
  for (const double one : {-1.0, 1.0}) {
    for (const double phi : {-golden, golden}) {
      for (const dvec3& corner : {dvec3(0, one, phi), dvec3(one, phi, 0), dvec3(phi, 0, one)}) {
        mesh.positions.push_back(glm::normalize(corner));
      }
    }
  }
  // Corners are neighbours where they are nearest; each three neighbours are a triangle.
  const auto adjacent = [&](std::uint32_t a, std::uint32_t b) {
    return glm::dot(mesh.positions[a], mesh.positions[b]) > 0.4;
  };
  for (std::uint32_t a = 0; a < 12; ++a) {
    for (std::uint32_t b = a + 1; b < 12; ++b) {
      for (std::uint32_t c = b + 1; c < 12; ++c) {
        if (adjacent(a, b) && adjacent(b, c) && adjacent(c, a)) {
          const auto& p = mesh.positions;
          const bool outward = glm::dot(p[a], glm::cross(p[b], p[c])) > 0;
          mesh.triangles.push_back(outward ? uvec3(a, b, c) : uvec3(a, c, b));
        }
      }
    }
  }
  return mesh;
}

void subdivide(Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [entry, is_new] = middles.try_emplace(std::minmax(a, b), mesh.positions.size());
    if (is_new) {
      mesh.positions.push_back(glm::normalize(mesh.positions[a] + mesh.positions[b]));
    }
    return entry->second;
  };
  std::vector<uvec3> triangles;
  for (const uvec3& t : mesh.triangles) {
    const uvec3 m(middle(t.x, t.y), middle(t.y, t.z), middle(t.z, t.x));
    triangles.insert(triangles.end(),
                     {uvec3(t.x, m.x, m.z), uvec3(t.y, m.y, m.x), uvec3(t.z, m.z, m.y), m});
  }
  mesh.triangles = std::move(triangles);
}

}  // namespace

Mesh make_sphere(int subdivisions) {
  assert(subdivisions >= 0 && subdivisions <= 8);
  Mesh mesh = make_icosahedron();
  for (int i = 0; i < subdivisions; ++i) {
    subdivide(mesh);
  }
  mesh.normals = mesh.positions;  // the normal of a unit sphere is the place
  mesh.normal_triangles = mesh.triangles;
  return mesh;
}

}  // namespace collage
