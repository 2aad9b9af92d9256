#include "geometry/smooth_normals.h"

#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace collage {

void set_smooth_normals(Mesh& mesh, double crease_degrees) {
  const double bend = std::cos(glm::radians(crease_degrees));
  std::vector<dvec3> face_normals;
  std::vector<std::vector<std::pair<std::uint32_t, double>>> around(mesh.positions.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<dvec3, 3> sides;
    for (int k = 0; k < 3; ++k) {
      sides[k] = glm::normalize(mesh.corner(t, (k + 1) % 3) - mesh.corner(t, k));
    }
    face_normals.push_back(glm::normalize(glm::cross(sides[0], sides[1])));
    for (int k = 0; k < 3; ++k) {
      const double cosine = glm::dot(sides[k], -sides[(k + 2) % 3]);
      around[mesh.triangles[t][k]].emplace_back(t, std::acos(glm::clamp(cosine, -1.0, 1.0)));
    }
  }
  mesh.normals.clear();
  mesh.normal_triangles.clear();
  std::map<std::tuple<double, double, double>, std::uint32_t> known;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    uvec3& indices = mesh.normal_triangles.emplace_back();
    for (int k = 0; k < 3; ++k) {
      dvec3 sum(0.0);
      for (const auto& [other, angle] : around[mesh.triangles[t][k]]) {
        sum += glm::dot(face_normals[t], face_normals[other]) >= bend ? angle * face_normals[other]
                                                                      : dvec3(0.0);
      }
      const dvec3 normal = to_millionths(glm::normalize(sum));
      const auto [entry, is_new] = known.try_emplace(
          {normal.x, normal.y, normal.z}, static_cast<std::uint32_t>(mesh.normals.size()));
      if (is_new) {
        mesh.normals.push_back(normal);
      }
      indices[k] = entry->second;
    }
  }
}

}  // namespace collage
