#include "geometry/subdivision.h"

namespace collage {

PolygonMesh catmull_clark(const PolygonMesh& mesh) {
  PolygonMesh result;
  result.positions.resize(mesh.positions.size());
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    result.positions.push_back(face_middle(mesh, f));
  }
  const auto face_point = [&](std::uint32_t face) {
    return static_cast<std::uint32_t>(mesh.positions.size()) + face;
  };

  struct Sums {
    dvec3 faces{0.0};
    dvec3 edges{0.0};
    int edge_count = 0;
  };
  std::vector<Sums> around(mesh.positions.size());
  const EdgeFaces edges = edge_faces(mesh);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> edge_points;
  for (const auto& [edge, left] : edges) {
    const auto [from, to] = edge;
    const dvec3 ends = mesh.positions[from] + mesh.positions[to];
    Sums& sums = around[from];
    sums.faces += result.positions[face_point(left.face)];
    sums.edges += 0.5 * ends;
    ++sums.edge_count;
    if (from < to) {
      const std::uint32_t right = edges.at({to, from}).face;
      edge_points[edge] = edge_points[{to, from}] =
          static_cast<std::uint32_t>(result.positions.size());
      result.positions.push_back(0.25 * (ends + result.positions[face_point(left.face)] +
                                         result.positions[face_point(right)]));
    }
  }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const double n = around[v].edge_count;
    result.positions[v] =
        ((around[v].faces + 2.0 * around[v].edges) / n + (n - 3.0) * mesh.positions[v]) / n;
  }
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const PolygonMesh::Face& face = mesh.faces[f];
    for (std::size_t k = 0; k < face.size(); ++k) {
      const std::uint32_t before = face[(k + face.size() - 1) % face.size()];
      const std::uint32_t after = face[(k + 1) % face.size()];
      result.faces.push_back({face[k], edge_points.at({face[k], after}), face_point(f),
                              edge_points.at({before, face[k]})});
    }
  }
  return result;
}

}  // namespace collage
