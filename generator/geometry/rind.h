#pragma once

#include <cstdint>
#include <span>

#include "geometry/polygon_mesh.h"

namespace collage {

/// The hollow shell under a closed surface, `thickness` deep, with the faces of `openings` as
/// windows through it: Akleman, Srinivasan and Chen 2003, "Interactive rind modeling". A sphere
/// with n > 0 windows becomes a surface of genus n - 1; without windows the cavity is a part of its
/// own. Windows must not share a corner. The inner surface runs parallel to the faces round each
/// vertex as far as their normals agree. Faces: those outside less the windows, the same inside,
/// the windows' walls.
PolygonMesh rind(const PolygonMesh& mesh, double thickness,
                 std::span<const std::uint32_t> openings);

}  // namespace collage
