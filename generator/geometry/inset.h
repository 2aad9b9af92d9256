#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/planar_region.h"

namespace collage {

/// The strip between the contours of a region and those of the region drawn in, as faces of a roof
/// that rises evenly from the contours.
struct Inset {
  /// x, y and the distance from the contours; those of the region come first, contour by contour.
  std::vector<dvec3> points;
  /// One a side of the region, counter-clockwise, by indices into `points`. Plane, but for corners
  /// with a point closer to the side than it should be.
  std::vector<std::vector<std::uint32_t>> faces;
  /// The contours drawn in, with their places in `points`.
  Region inner;
  std::vector<std::uint32_t> inner_points;
  /// triangulated(inner), by indices into `points`.
  std::vector<uvec3> cap;
};

/// Draws a connected region in by `distance`; 0 gives no faces, and the region itself. Sides move
/// inwards and sides that have shrunk to nothing are left out (the edge events of the straight
/// skeleton, Aichholzer et al. 1995, "A novel type of skeleton for polygons"); at corners sharper
/// than 60 degrees that the region lies round, the strip is narrower.
///
/// Nothing where that parts the region or makes it vanish in some place: the strokes are too thin.
/// Cost: O(n log n).
std::optional<Inset> inset(const Region& region, double distance);

}  // namespace collage
