#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/mesh.h"

namespace collage {

/// How far apart vertices may be that are welded, as a share of the longest side of the mesh's box.
inline constexpr double weld_share = 1e-5;

/// Closes cracks: vertices that should be at one place and are apart by rounding are moved to one.
/// In their order, each vertex of an edge with a single triangle moves to the first of those before
/// it that stayed where it was and is within `weld_share`. It stays where its move would leave a
/// triangle without area; all stay where the number of such edges would not fall. Positions change
/// only, not indices, normals, uv and materials. Returns the number of places that moved.
///
/// Vertices at the same place stay apart for the sake of their uv and normals: they count as one in
/// every question about edges (Topology).
///
/// Cost: O(n log n).
std::size_t weld(Mesh& mesh);

/// What close_holes() added.
struct ClosedHoles {
  std::size_t holes = 0;
  std::size_t triangles = 0;
};

inline constexpr std::size_t largest_hole_edges = 32;
/// Longest side of a hole's box, as a share of that of its sheet's.
inline constexpr double widest_hole_share = 0.1;
inline constexpr double sharpest_lid_degrees = 60.0;

/// Closes the sheets (see find_sheets()) that small holes keep open. A hole has at most
/// `largest_hole_edges` edges, is no wider than `widest_hole_share`, and the triangles that close
/// it go on from those round it with bends of `sharpest_lid_degrees` at most: mouths of cups and
/// ends of pipes are none. A sheet that would stay open nevertheless is left as it is: a sieve
/// keeps its holes.
///
/// The new triangles come last, made by triangulate(), with the material, uv and normals of the
/// triangles round the hole. Cost: O(n log n).
ClosedHoles close_holes(Mesh& mesh);

/// weld(), close_holes() and orient(), with a line for people for each of them that did something.
std::vector<std::string> repair(Mesh& mesh);

}  // namespace collage
