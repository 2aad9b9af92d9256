#pragma once

#include <cstdint>
#include <vector>

#include "geometry/planar_region.h"

namespace collage {

/// What GLU's tessellator makes of contours. Points go by their place in the input, contour by
/// contour.
struct Tessellation {
  /// Loops of the boundary, or one list of triangles.
  std::vector<std::vector<std::uint32_t>> primitives;
  /// Points that it added where contours cross; numbered on from those of the input.
  std::vector<dvec2> added;
  bool failed = false;
};

/// The boundary of what is wound round other than zero times, the inside to the left.
Tessellation boundary_by_glu(const std::vector<Contour>& contours);

/// Triangles of what is wound round counter-clockwise.
Tessellation triangles_by_glu(const std::vector<Contour>& contours);

}  // namespace collage
