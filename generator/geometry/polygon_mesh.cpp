#include "geometry/polygon_mesh.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <iterator>
#include <numeric>

#include "geometry/polygon.h"

namespace collage {
namespace {

/// Whether no point is in front of the plane of three, which face outwards then.
bool is_outermost(std::span<const dvec3> points, const dvec3& on_plane, const dvec3& normal) {
  return std::all_of(points.begin(), points.end(), [&](const dvec3& point) {
    return glm::dot(point - on_plane, normal) < 1e-9 * glm::length(normal);
  });
}

/// The points on a plane, counter-clockwise as seen against its normal, from the lowest on.
PolygonMesh::Face face_in_plane(std::span<const dvec3> points, const dvec3& on_plane,
                                const dvec3& normal) {
  PolygonMesh::Face face;
  dvec3 middle(0.0);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (std::abs(glm::dot(points[i] - on_plane, normal)) < 1e-9 * glm::length(normal)) {
      face.push_back(i);
      middle += points[i];
    }
  }
  middle /= static_cast<double>(face.size());
  const dvec3 u = glm::normalize(points[face[0]] - middle);
  const dvec3 v = glm::cross(glm::normalize(normal), u);
  const auto turn = [&](std::uint32_t i) {
    const dvec3 arm = points[i] - middle;
    const double angle = std::atan2(glm::dot(arm, v), glm::dot(arm, u));
    return angle < -1e-9 ? angle + 7.0 : angle;
  };
  std::sort(face.begin(), face.end(),
            [&](std::uint32_t a, std::uint32_t b) { return turn(a) < turn(b); });
  return face;
}

}  // namespace

EdgeFaces edge_faces(const PolygonMesh& mesh) {
  EdgeFaces edges;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const PolygonMesh::Face& face = mesh.faces[f];
    for (std::uint32_t k = 0; k < face.size(); ++k) {
      [[maybe_unused]] const bool is_new =
          edges.try_emplace({face[k], face[(k + 1) % face.size()]}, FaceCorner{f, k}).second;
      assert(is_new);
    }
  }
  return edges;
}

dvec3 face_middle(const PolygonMesh& mesh, std::uint32_t face) {
  const PolygonMesh::Face& corners = mesh.faces[face];
  const dvec3 sum = std::accumulate(
      corners.begin(), corners.end(), dvec3(0.0),
      [&](const dvec3& so_far, std::uint32_t corner) { return so_far + mesh.positions[corner]; });
  return sum / static_cast<double>(corners.size());
}

dvec3 face_normal(const PolygonMesh& mesh, std::uint32_t face) {
  const PolygonMesh::Face& corners = mesh.faces[face];
  const dvec3& first = mesh.positions[corners[0]];
  dvec3 area(0.0);
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    area += glm::cross(mesh.positions[corners[k]] - first, mesh.positions[corners[k + 1]] - first);
  }
  return glm::normalize(area);
}

std::uint32_t face_towards(const PolygonMesh& mesh, const dvec3& direction) {
  std::uint32_t best = 0;
  for (std::uint32_t f = 1; f < mesh.faces.size(); ++f) {
    if (glm::dot(face_normal(mesh, f), direction) > glm::dot(face_normal(mesh, best), direction)) {
      best = f;
    }
  }
  return best;
}

void raise_face(PolygonMesh& mesh, std::uint32_t face, std::span<const dvec3> upper) {
  const PolygonMesh::Face lower = mesh.faces[face];
  assert(upper.size() == lower.size());
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const auto n = static_cast<std::uint32_t>(lower.size());
  mesh.positions.insert(mesh.positions.end(), upper.begin(), upper.end());
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t next = (k + 1) % n;
    mesh.faces.push_back({lower[k], lower[next], first + next, first + k});
  }
  std::iota(mesh.faces[face].begin(), mesh.faces[face].end(), first);
}

PolygonMesh convex_polyhedron(std::vector<dvec3> corners) {
  PolygonMesh mesh;
  mesh.positions = std::move(corners);
  const auto& p = mesh.positions;
  for (std::uint32_t a = 0; a < p.size(); ++a) {
    for (std::uint32_t b = a + 1; b < p.size(); ++b) {
      for (std::uint32_t c = b + 1; c < p.size(); ++c) {
        dvec3 normal = glm::cross(p[b] - p[a], p[c] - p[a]);
        for ([[maybe_unused]] const int side : {0, 1}) {
          // Each face once: by its first three corners.
          if (is_outermost(p, p[a], normal)) {
            PolygonMesh::Face face = face_in_plane(p, p[a], normal);
            PolygonMesh::Face sorted = face;
            std::sort(sorted.begin(), sorted.end());
            if (sorted[0] == a && sorted[1] == b && sorted[2] == c) {
              mesh.faces.push_back(std::move(face));
            }
          }
          normal = -normal;
        }
      }
    }
  }
  return mesh;
}

Mesh triangulated(const PolygonMesh& mesh) {
  Mesh triangles;
  std::transform(mesh.positions.begin(), mesh.positions.end(),
                 std::back_inserter(triangles.positions), to_millionths);
  std::vector<dvec3> corners;
  for (const PolygonMesh::Face& face : mesh.faces) {
    corners.clear();
    for (const std::uint32_t corner : face) {
      corners.push_back(mesh.positions[corner]);
    }
    for (const auto& [a, b, c] : triangulate(corners)) {
      triangles.triangles.emplace_back(face[a], face[b], face[c]);
    }
  }
  return triangles;
}

}  // namespace collage
