#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "geometry/box_tree.h"
#include "geometry/mesh_check.h"
#include "geometry/polygon_mesh.h"
#include "geometry/triangle_intersection.h"

namespace collage {

/// The sum of the genera of a closed two-manifold mesh's parts, by Euler's formula.
inline int genus_of(const Mesh& mesh) {
  const MeshReport report = check_mesh(mesh);
  const auto euler = static_cast<int>(report.vertices) - static_cast<int>(report.triangles) / 2;
  return static_cast<int>(report.parts) - euler / 2;
}

/// V - E + F of a closed mesh.
inline int euler_characteristic(const PolygonMesh& mesh) {
  std::set<std::uint32_t> used;
  for (const PolygonMesh::Face& face : mesh.faces) {
    used.insert(face.begin(), face.end());
  }
  const auto edges = static_cast<int>(edge_faces(mesh).size() / 2);
  return static_cast<int>(used.size()) - edges + static_cast<int>(mesh.faces.size());
}

/// Every edge has its opposite, and the triangles enclose a positive volume.
inline bool is_closed_outward(const PolygonMesh& mesh) {
  const MeshReport report = check_mesh(triangulated(mesh));
  return report.closed && report.inconsistent_edges == 0 && report.nonmanifold_edges == 0 &&
         report.degenerate_triangles == 0 && report.volume > 0.0;
}

/// Pairs of triangles without a common corner that have a point in common.
inline std::size_t self_intersections(const Mesh& mesh) {
  std::vector<Box> boxes;
  const auto corners = [&](std::size_t t) {
    return Corners{mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)};
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Box& box = boxes.emplace_back();
    for (const dvec3& corner : corners(t)) {
      box.include(corner);
    }
  }
  const auto are_neighbours = [&](std::size_t s, std::size_t t) {
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        if (mesh.triangles[s][i] == mesh.triangles[t][k]) {
          return true;
        }
      }
    }
    return false;
  };
  std::size_t found = 0;
  const BoxTree tree(boxes);
  for (std::size_t s = 0; s < boxes.size(); ++s) {
    tree.find(boxes[s], [&](std::uint32_t t) {
      found += s < t && !are_neighbours(s, t) && triangles_intersect(corners(s), corners(t));
    });
  }
  return found;
}

}  // namespace collage
