#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/topology.h"

namespace collage {

/// Triangles that hang together and so are turned over together. They are gathered across edges of
/// two triangles, and then across edges of more where the pieces need each other to run the edge as
/// often one way as the other.
struct Sheet {
  std::vector<std::uint32_t> triangles;
  /// Every edge is run as often one way as the other.
  bool closed = true;
  /// Cannot be made to agree, as a Möbius strip; its triangles stay as they are.
  bool one_sided = false;
  /// Signed, with the triangles as they stand once they agree; that of the cone from the centroid
  /// where it is open.
  double volume = 0.0;
  double area = 0.0;
  Box box;
};

struct Sheets {
  /// By their first triangle; triangles with two corners at one place are in none.
  std::vector<Sheet> sheets;
  /// For each triangle 1 where it has to be turned over to agree with most of its sheet.
  std::vector<char> flipped;
};

/// Cost: O(n log n).
Sheets find_sheets(const Mesh& mesh);

/// The corners of a triangle, the last two swapped where it is flipped.
inline std::array<dvec3, 3> oriented_corners(const Mesh& mesh, const std::vector<char>& flipped,
                                             std::uint32_t triangle) {
  const bool turned = flipped[triangle] != 0;
  return {mesh.corner(triangle, 0), mesh.corner(triangle, turned ? 2 : 1),
          mesh.corner(triangle, turned ? 1 : 2)};
}

}  // namespace collage
