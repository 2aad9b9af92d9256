#pragma once

#include <functional>
#include <span>

#include "geometry/polygon_mesh.h"

namespace collage {

/// The boundary of those cells of a grid that `is_solid` picks by their middles: quads between the
/// planes of `xs`, `ys` and `zs`, each in rising order. Solid cells must not meet along an edge or
/// in a corner only, where no two-manifold surface runs. Furniture is made so.
PolygonMesh cell_surface(std::span<const double> xs, std::span<const double> ys,
                         std::span<const double> zs,
                         const std::function<bool(const dvec3& middle)>& is_solid);

}  // namespace collage
