#pragma once

#include <vector>

#include "geometry/mesh.h"

namespace collage::bench {

#ifdef COLLAGE_OPENVDB
inline constexpr bool has_level_sets = true;
#else
inline constexpr bool has_level_sets = false;
#endif

/// Radii of `count` spheres without overlap in a mesh, by OpenVDB's level set of so many voxels on
/// the longest side and its fillWithSpheres(). Only where there are level sets.
std::vector<double> level_set_spheres(const Mesh& mesh, int voxels, int count);

}  // namespace collage::bench
