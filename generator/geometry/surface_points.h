#pragma once

#include <cstddef>
#include <vector>

#include "geometry/mesh.h"

namespace collage {

struct SurfacePoint {
  dvec3 position;
  /// Unit vector; the triangle runs counter-clockwise around it.
  dvec3 normal;
};

/// Points spread evenly over a mesh's triangles: these are laid in a row, neighbours next to each
/// other, the row is cut into `count` pieces of equal area, and each piece gets a point in the
/// triangle at a random place of it. Within a triangle consecutive points are spread evenly, too.
/// Always the same ones for the same mesh. None where there is no area.
/// Cost: O((t + count) log t) for t triangles.
std::vector<SurfacePoint> spread_over_surface(const Mesh& mesh, std::size_t count);

}  // namespace collage
