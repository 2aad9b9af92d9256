#pragma once

#include <cstdint>
#include <span>

#include "geometry/polygon_mesh.h"

namespace collage {

/// The outline, counter-clockwise in x and y, from z = -depth / 2 to z = depth / 2. With a bevel
/// the edges of both ends are cut off at 45° (`bevel` <= depth / 2): the ends are smaller by that
/// much on all sides, which must leave them an outline without crossings. The ends are the first
/// two faces, the front (+z) first.
PolygonMesh extrude(std::span<const dvec2> outline, double depth, double bevel = 0.0);

/// Grows the mesh out of a face: which moves by `move`, scaled by `scale` about its middle, and
/// keeps its number, while quads close the gap. With no move it is an inset.
void extrude_face(PolygonMesh& mesh, std::uint32_t face, const dvec3& move, double scale);

}  // namespace collage
