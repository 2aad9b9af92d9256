#pragma once

#include "fitting/free_space.h"
#include "support/meshes.h"

namespace collage::test {

/// A blob to fill, and a ring to fill it with.
struct ShapeWorld {
  /// The ring's tube has a radius of `tube` of the ring's.
  ShapeWorld(double tube, int resolution)
      : mesh(torus_mesh(1.0, tube, 24, 12)), space(target, resolution, status) {}

  Mesh target_mesh = blob_mesh(1.0, 0.2, 16);
  Mesh mesh;
  Status status;
  MeshTarget target{target_mesh};
  FreeSpace space;
  Element element{mesh};
  ShapedElement shape{mesh, element, measure_shape(mesh, element)};
};

}  // namespace collage::test
