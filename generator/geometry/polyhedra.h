#pragma once

#include "geometry/polygon_mesh.h"

namespace collage {

// Convex polyhedra round the origin, with corners at distance 1.

PolygonMesh regular_tetrahedron();
PolygonMesh regular_cube();
PolygonMesh regular_octahedron();
PolygonMesh regular_dodecahedron();

/// A prism on a regular polygon of `corners`, along y, with square sides where `stretch` is 1.
PolygonMesh regular_prism(int corners, double stretch = 1.0);

}  // namespace collage
