#pragma once

#include "geometry/mesh.h"
#include "geometry/solid.h"

namespace collage {

/// The target as the measures look at it. The mesh has triangles and must outlive the shape.
struct TargetShape {
  const Mesh& mesh;
  Box box;
  /// Longest side of the box: the unit of relative lengths.
  double side;
  Solid solid;

  explicit TargetShape(const Mesh& target)
      : mesh(target),
        box(bounding_box(target)),
        side(box.longest_side()),
        solid(target, box.center(), 0.5 * glm::length(box.extent())) {}
};

}  // namespace collage
