#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "geometry/mesh.h"

namespace collage {

/// What shapes are modelled in before they become triangles: faces of three or more corners,
/// counter-clockwise seen from outside.
struct PolygonMesh {
  using Face = std::vector<std::uint32_t>;

  std::vector<dvec3> positions;
  std::vector<Face> faces;
};

/// Where a face stands at a directed edge of its own.
struct FaceCorner {
  std::uint32_t face;
  /// The edge runs from this corner of the face to the next.
  std::uint32_t corner;
};

/// The face on the left of each directed edge (from, to). A mesh is closed, two-manifold at its
/// edges and oriented where each edge has its opposite. Asserts that no edge has two faces.
using EdgeFaces = std::map<std::pair<std::uint32_t, std::uint32_t>, FaceCorner>;
EdgeFaces edge_faces(const PolygonMesh& mesh);

/// The mean of a face's corners.
dvec3 face_middle(const PolygonMesh& mesh, std::uint32_t face);

/// The unit vector along a face's area vector, outwards.
dvec3 face_normal(const PolygonMesh& mesh, std::uint32_t face);

/// The face whose normal is nearest to a direction; of equals the first.
std::uint32_t face_towards(const PolygonMesh& mesh, const dvec3& direction);

/// Joins a face's corners in turn with those of `upper`, a face's worth of new positions, by quads,
/// and puts the face there: the step of all that grows out of a face.
void raise_face(PolygonMesh& mesh, std::uint32_t face, std::span<const dvec3> upper);

/// The boundary of the convex hull of points each of which is a corner of it; faces of more than
/// three corners come out whole. Cost: O(n^4), for the few corners of a polyhedron.
PolygonMesh convex_polyhedron(std::vector<dvec3> corners);

/// Cut into triangles by triangulate(), positions rounded to_millionths().
Mesh triangulated(const PolygonMesh& mesh);

}  // namespace collage
