#pragma once

#include <span>

#include "packing/clearance_field.h"
#include "packing/surfaces.h"

namespace collage {

/// The hole with its centre moved, by less than `reach`, to where the clearance is larger: close to
/// its local maximum, and never less than it was. `reach` is at most the hole's clearance, so that
/// no surface is crossed. Other than the target, only the surfaces in `near` are asked: all that
/// may come nearer to the hole's centre than its clearance and twice `reach`, in rising order.
///
/// No point seen on a surface is nearer than the clearance: the least of the distances to them is
/// an upper bound of it, everywhere. The surfaces are asked where that bound is largest, and what
/// they answer lowers it there, until the two meet. Cost: about 30 queries.
Hole climbed(const Surfaces& surfaces, const Hole& hole, std::span<const SurfaceId> near,
             double reach);

}  // namespace collage
