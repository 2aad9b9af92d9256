#pragma once

#include <array>

#include <glm/glm.hpp>

namespace collage {

using Corners = std::array<glm::dvec3, 3>;

/// True where two closed triangles have a point in common, be it a single one: touching, coplanar
/// and degenerate triangles included. Exact for the doubles given, by the signs of orient3d() and
/// orient2d() alone. Cost: about 20 predicates where the planes cross, two where not.
bool triangles_intersect(const Corners& s, const Corners& t);

}  // namespace collage
