#pragma once

#include <cstddef>
#include <span>

#include "geometry/mesh.h"

namespace collage {

struct Sphere {
  dvec3 center{0.0};
  double radius = 0.0;
};

/// The smallest sphere that encloses all points, of which there must be at least one; their order
/// of magnitude is between 1e-30 and 1e30.
///
/// Pivots as Gärtner 1999 ("Fast and robust smallest enclosing balls"): the farthest point outside
/// joins the at most four points that hold the sphere, and the smallest sphere of those five is
/// found by trying all subsets, so that nothing depends on a tolerance. The radius is larger than
/// the best by at most a few roundings, and so that no point is outside, in double or in exact
/// arithmetic.
///
/// Cost: O(n) a pivot, about ten pivots.
Sphere smallest_enclosing_sphere(std::span<const dvec3> points);

/// The point that is farthest from `center`; of several the first.
struct FarthestPoint {
  std::size_t index = 0;
  double distance = 0.0;
  /// Unit vector from the centre to the point; +y where both coincide.
  dvec3 direction{0.0, 1.0, 0.0};
};
FarthestPoint farthest_point(std::span<const dvec3> points, const dvec3& center);

}  // namespace collage
