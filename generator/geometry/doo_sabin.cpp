#include <cmath>
#include <numbers>
#include <numeric>

#include "geometry/subdivision.h"

namespace collage {
namespace {

/// The new corner of a face at its corner k.
dvec3 new_corner(const PolygonMesh& mesh, const PolygonMesh::Face& face, std::size_t k) {
  const auto n = static_cast<double>(face.size());
  dvec3 sum = (n + 5.0) / (4.0 * n) * mesh.positions[face[k]];
  for (std::size_t j = 1; j < face.size(); ++j) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(j) / n;
    sum += (3.0 + 2.0 * std::cos(angle)) / (4.0 * n) * mesh.positions[face[(k + j) % face.size()]];
  }
  return sum;
}

}  // namespace

PolygonMesh doo_sabin(const PolygonMesh& mesh) {
  PolygonMesh result;
  std::vector<std::uint32_t> first;  // of a face's new corners
  for (const PolygonMesh::Face& face : mesh.faces) {
    first.push_back(static_cast<std::uint32_t>(result.positions.size()));
    for (std::size_t k = 0; k < face.size(); ++k) {
      result.positions.push_back(new_corner(mesh, face, k));
    }
    PolygonMesh::Face& smaller = result.faces.emplace_back(face.size());
    std::iota(smaller.begin(), smaller.end(), first.back());
  }
  const EdgeFaces edges = edge_faces(mesh);
  const auto at_start = [&](const FaceCorner& c) { return first[c.face] + c.corner; };
  const auto at_end = [&](const FaceCorner& c) {
    return first[c.face] + (c.corner + 1) % static_cast<std::uint32_t>(mesh.faces[c.face].size());
  };
  std::vector<bool> done(mesh.positions.size(), false);
  for (const auto& [edge, left] : edges) {
    const auto [from, to] = edge;
    const FaceCorner& right = edges.at({to, from});
    if (from < to) {
      result.faces.push_back({at_end(left), at_start(left), at_end(right), at_start(right)});
    }
    if (!done[from]) {
      done[from] = true;
      PolygonMesh::Face round;
      FaceCorner here = left;
      do {
        round.push_back(at_start(here));
        const PolygonMesh::Face& face = mesh.faces[here.face];
        const std::uint32_t before = face[(here.corner + face.size() - 1) % face.size()];
        here = edges.at({from, before});
      } while (here.face != left.face);
      result.faces.push_back(round);
    }
  }
  return result;
}

}  // namespace collage
