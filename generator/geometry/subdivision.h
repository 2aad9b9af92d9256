#pragma once

#include "geometry/polygon_mesh.h"

namespace collage {

/// One step of Catmull and Clark 1978, "Recursively generated B-spline surfaces on arbitrary
/// topological meshes": each corner of each face becomes a quad. Takes closed meshes. O(n log n).
PolygonMesh catmull_clark(const PolygonMesh& mesh);

/// One step of Doo and Sabin 1978, "Behaviour of recursive division surfaces near extraordinary
/// points", with their weights: a face for each face, edge and vertex; shrinks a little and rounds
/// off edges. Takes closed meshes. O(n log n).
PolygonMesh doo_sabin(const PolygonMesh& mesh);

}  // namespace collage
