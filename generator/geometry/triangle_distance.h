#pragma once

#include "geometry/triangle_intersection.h"

namespace collage {

/// Squared distance between two closed segments, which may be points (Ericson 2005, "Real-Time
/// Collision Detection", 5.1.9).
double squared_segment_distance(const glm::dvec3& p1, const glm::dvec3& q1, const glm::dvec3& p2,
                                const glm::dvec3& q2);

/// Distance between two closed triangles, which may be segments or points: 0 where they have a
/// point in common, exactly; else the least of the nine distances between edges and the six
/// between corners and faces, up to rounding.
double triangle_distance(const Corners& s, const Corners& t);

}  // namespace collage
