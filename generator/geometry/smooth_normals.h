#pragma once

#include "geometry/mesh.h"

namespace collage {

/// Replaces the normals by smooth ones: at each corner the mean of the triangles round its vertex,
/// weighted by their angles there (Thürmer and Wüthrich 1998), that are bent against the corner's
/// own triangle by less than `crease_degrees`. Cost: O(n d) with d triangles a vertex.
void set_smooth_normals(Mesh& mesh, double crease_degrees);

}  // namespace collage
