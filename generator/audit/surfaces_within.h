#pragma once

#include "geometry/box_tree.h"
#include "geometry/boxes.h"
#include "geometry/instance.h"

namespace collage {

/// A mesh and a hierarchy over its triangles, for distances between surfaces. The mesh must outlive
/// it.
struct SurfaceTree {
  const Mesh& mesh;
  BoxTree triangles;

  explicit SurfaceTree(const Mesh& source) : mesh(source), triangles(boxes_of_triangles(source)) {}
};

/// True where the surfaces of two instances come as near to each other as `gap`, or nearer, up to
/// rounding. Both hierarchies are descended together, the nearest boxes first, until a pair of
/// triangles, or of boxes as a whole, is within the gap. Allocates nothing.
bool surfaces_within(double gap, const SurfaceTree& a, const Instance& instance_a,
                     const SurfaceTree& b, const Instance& instance_b);

}  // namespace collage
