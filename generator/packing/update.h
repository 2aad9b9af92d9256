#pragma once

#include "geometry/instance.h"
#include "packing/clearance_field.h"
#include "packing/element.h"

namespace collage {

/// Accounts for a new instance (Muhm 2011, Fig. 12): voxels inside it are flagged, every other
/// voxel to which it is now the nearest surface gets its distance. `hole_clearance` is the largest
/// clearance before: no farther voxel than that beyond the instance's sphere can change, so at most
/// twice the hole's radius is looked at. Returns the number of voxels flagged.
/// Runs on all threads; the result does not depend on their number.
std::size_t update(ClearanceField& field, const Element& element, const Instance& instance,
                   SurfaceId id, double hole_clearance);

}  // namespace collage
