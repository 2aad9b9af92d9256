#pragma once

#include "scene/composition.h"

namespace collage {

/// What the camera has to frame, in the units of the meshes.
struct CompositionBounds {
  /// Box of all instances' vertices; the target's box where there is no instance.
  Box instances;
  /// Distance of the farthest vertex, of the instances and of the target's mesh, from the upright
  /// axis through the middle of the box of both.
  double radius = 0.0;
};

/// Exact up to rounding. Cost: eight corners an instance, and all vertices of those few whose
/// corners stand out.
CompositionBounds bounds_of(const Composition& composition);

}  // namespace collage
