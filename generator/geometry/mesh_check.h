#pragma once

#include <cstddef>
#include <string>

#include "geometry/mesh.h"

namespace collage {

/// What is to be known of a mesh before it is filled or placed. Vertices at exactly the same place
/// count as one.
struct MeshReport {
  std::size_t triangles = 0;
  std::size_t vertices = 0;
  /// Sets of triangles that hang together by edges.
  std::size_t parts = 0;
  /// Edges of one triangle, and of more than two.
  std::size_t boundary_edges = 0;
  std::size_t nonmanifold_edges = 0;
  /// Triangles without area, be it by corners at the same place.
  std::size_t degenerate_triangles = 0;
  /// Edges that are not run as often one way as the other, boundary edges aside.
  std::size_t inconsistent_edges = 0;
  /// An even number of triangles at each edge, so that there is an inside.
  bool closed = false;
  /// enclosed_volume(); means something where `closed` and no edge is inconsistent.
  double volume = 0.0;
  double area = 0.0;
  Box box;
};

/// Cost: O(n log n).
MeshReport check_mesh(const Mesh& mesh);

/// One line for people: "6,598 triangles in 1 part, closed, volume 0.749, 2 x 1.98 x 1.55".
std::string text_of(const MeshReport& report);

/// What is done to a mesh that is not as it should be: repair(), or nothing.
enum class Repair { full, none };

/// What orient() did. A sheet is a set of triangles that must be turned over together; parts that
/// only touch at an edge are sheets of their own.
struct Orientation {
  std::size_t sheets = 0;
  /// Sheets turned over as a whole.
  std::size_t turned_sheets = 0;
  /// Triangles turned over to agree with their sheet.
  std::size_t mended_triangles = 0;
  /// Sheets with one side only, such as a Möbius strip, which nothing can put right.
  std::size_t one_sided_sheets = 0;
};

/// "turned 2 of 3 parts outside out", or "" where nothing was done.
std::string text_of(const Orientation& orientation);

/// Makes the triangles of each sheet agree, most of them staying as they are, and turns sheets so
/// that they face outwards:
/// a closed sheet inside none other has a positive volume; one within others is turned with the
/// outermost around it, so that cavities stay cavities; an open sheet is turned where it is
/// clearly hollow the wrong way (its cone from its centroid has a negative volume, of a twentieth
/// or more of a ball of its area), else left as it is. Normals of turned triangles are turned where
/// they would point inwards. Turns triangles only; positions, order and materials stay.
///
/// Cost: O(n log n); where a closed sheet lies in the box of another and one is inside out, also
/// the product of their numbers of triangles at worst.
Orientation orient(Mesh& mesh);

}  // namespace collage
