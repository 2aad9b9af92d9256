#pragma once

#include <cstdint>
#include <span>

#include "geometry/polygon_mesh.h"

namespace collage {

/// Two faces of one mesh with equally many corners.
struct FacePair {
  std::uint32_t from;
  std::uint32_t to;
};

struct HandleShape {
  /// Quads along the handle, at least 1.
  int steps = 4;
  /// How far the handle's control points stand out from its two faces: negative through the
  /// inside, where it bores a tunnel.
  double reach = 1.0;
  /// Width half-way, where the mean of the faces' widths is 1.
  double waist = 1.0;
  /// Corners by which the handle turns more than it has to.
  int twist = 0;
};

/// Joins each pair of faces by a handle in place of the two, which adds 1 to the genus where they
/// belong to one part: Srinivasan, Akleman and Chen 2002, "Interactive construction of
/// multi-segment curved handles". The path is a cubic Bézier curve along the faces' normals; the
/// section goes over from one face's polygon to the other's, turning as little as it can. Handles
/// are not kept from crossing each other. Faces keep their order, less those in pairs.
PolygonMesh with_handles(PolygonMesh mesh, std::span<const FacePair> pairs,
                         const HandleShape& shape);

}  // namespace collage
