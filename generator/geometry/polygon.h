#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace collage {

/// Triangles of a polygon as indices into `corners`, in the polygon's own sense of rotation.
///
/// Cuts off ears (Meisters 1975) in the plane across the polygon's area vector (Newell's normal).
/// Concave, not quite planar and keyhole polygons come out right; collinear corners are kept, so
/// that neighbours still share their edges; a convex quad is cut along its shorter diagonal.
/// A polygon that crosses itself comes out as n - 2 triangles of some kind.
///
/// Takes any number of corners; fewer than three give nothing. Cost: O(n) where convex, O(n r) as a
/// rule with r reflex corners, O(n^2 r) at worst.
std::vector<std::array<int, 3>> triangulate(std::span<const dvec3> corners);

}  // namespace collage
