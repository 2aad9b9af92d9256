#include "geometry/rind.h"

#include <algorithm>
#include <cassert>

namespace collage {
namespace {

/// For each vertex the way inwards by which the faces round it move by 1, on the whole.
std::vector<dvec3> ways_in(const PolygonMesh& mesh) {
  std::vector<std::vector<dvec3>> normals(mesh.positions.size());
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    for (const std::uint32_t corner : mesh.faces[f]) {
      normals[corner].push_back(face_normal(mesh, f));
    }
  }
  std::vector<dvec3> ways;
  for (const std::vector<dvec3>& around : normals) {
    dvec3 sum(0.0);
    for (const dvec3& normal : around) {
      sum += normal;
    }
    // With n = sum / |sum| the mean of dot(n, normal) is |sum| / count.
    ways.push_back(-sum * static_cast<double>(around.size()) / glm::dot(sum, sum));
  }
  return ways;
}

}  // namespace

PolygonMesh rind(const PolygonMesh& mesh, double thickness,
                 std::span<const std::uint32_t> openings) {
  PolygonMesh result;
  result.positions = mesh.positions;
  const auto count = static_cast<std::uint32_t>(mesh.positions.size());
  const std::vector<dvec3> ways = ways_in(mesh);
  for (std::uint32_t v = 0; v < count; ++v) {
    result.positions.push_back(mesh.positions[v] + thickness * ways[v]);
  }
  std::vector<PolygonMesh::Face> inner;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    if (std::find(openings.begin(), openings.end(), f) == openings.end()) {
      result.faces.push_back(mesh.faces[f]);
      PolygonMesh::Face& face = inner.emplace_back(mesh.faces[f].rbegin(), mesh.faces[f].rend());
      for (std::uint32_t& corner : face) {
        corner += count;
      }
    }
  }
  result.faces.insert(result.faces.end(), inner.begin(), inner.end());
  std::vector<bool> is_at_window(count, false);
  for (const std::uint32_t opening : openings) {
    const PolygonMesh::Face& window = mesh.faces[opening];
    for (std::size_t k = 0; k < window.size(); ++k) {
      const std::uint32_t a = window[k];
      const std::uint32_t b = window[(k + 1) % window.size()];
      assert(!is_at_window[a]);
      is_at_window[a] = true;
      result.faces.push_back({a, b, b + count, a + count});
    }
  }
  return result;
}

}  // namespace collage
