#include "geometry/extrusion.h"

#include <cassert>
#include <numeric>

namespace collage {
namespace {

dvec2 outward_normal(const dvec2& from, const dvec2& to) {
  const dvec2 way = glm::normalize(to - from);
  return {way.y, -way.x};
}

/// The outline at height z, with its sides moved inwards.
std::vector<dvec3> ring(std::span<const dvec2> outline, double inset, double z) {
  std::vector<dvec3> points;
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const dvec2 before = outward_normal(outline[(i + n - 1) % n], outline[i]);
    const dvec2 after = outward_normal(outline[i], outline[(i + 1) % n]);
    const dvec2 mitre = (before + after) / (1.0 + glm::dot(before, after));
    points.emplace_back(outline[i] - inset * mitre, z);
  }
  return points;
}

}  // namespace

PolygonMesh extrude(std::span<const dvec2> outline, double depth, double bevel) {
  assert(outline.size() >= 3);
  assert(bevel >= 0.0 && bevel <= 0.5 * depth);
  const double end = 0.5 * depth;
  PolygonMesh mesh;
  mesh.positions = ring(outline, bevel, -end);
  PolygonMesh::Face front(outline.size());
  std::iota(front.begin(), front.end(), 0U);
  mesh.faces = {front, PolygonMesh::Face(front.rbegin(), front.rend())};
  if (bevel > 0.0) {
    raise_face(mesh, 0, ring(outline, 0.0, bevel - end));
    if (bevel < end) {
      raise_face(mesh, 0, ring(outline, 0.0, end - bevel));
    }
  }
  raise_face(mesh, 0, ring(outline, bevel, end));
  return mesh;
}

void extrude_face(PolygonMesh& mesh, std::uint32_t face, const dvec3& move, double scale) {
  const dvec3 middle = face_middle(mesh, face);
  std::vector<dvec3> upper;
  for (const std::uint32_t corner : mesh.faces[face]) {
    upper.push_back(middle + move + scale * (mesh.positions[corner] - middle));
  }
  raise_face(mesh, face, upper);
}

}  // namespace collage
