#pragma once

#include <glm/glm.hpp>

namespace collage {

/// On which side of the plane through a, b, c the point d lies: the sign of det(a-d, b-d, c-d), +1
/// where a, b, c run counter-clockwise seen from above and d is below. Exact for the doubles given:
/// evaluated in double with an error bound (Shewchuk 1997, "Adaptive precision floating-point
/// arithmetic and fast robust geometric predicates", the bound of his stage A), and in rational
/// numbers where that does not decide. Coordinates are finite.
int orient3d(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d);

/// +1 where a, b, c run counter-clockwise, 0 where they are in line. Exact as well.
int orient2d(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

}  // namespace collage
