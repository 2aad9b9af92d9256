#pragma once

#include <vector>

#include "scene/composition.h"

namespace collage {

/// What the camera has to frame, in the units of the meshes.
struct CompositionBounds {
  /// Box of all instances' and props' vertices; the target's box where there are none.
  Box shown;
  /// Distance of the farthest vertex, of what is shown and of the target's mesh, from the upright
  /// axis through the middle of the box of both.
  double radius = 0.0;
  /// The farthest of the shown vertices in 128 directions all round, and of the target's. What
  /// they span falls short of the rest by 2 % of its size at most. Where there are no vertices, the
  /// corners of the target's box.
  std::vector<dvec3> outline;
  std::vector<dvec3> target_outline;
};

/// Exact up to rounding. Cost: a product an instance and direction, and all vertices of those few
/// whose balls and corners stand out: 0.1 s for 300,000.
CompositionBounds bounds_of(const Composition& composition);

}  // namespace collage
