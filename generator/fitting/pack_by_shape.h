#pragma once

#include <span>

#include "base/status.h"
#include "fitting/free_space.h"
#include "fitting/kinds.h"
#include "fitting/placed_shapes.h"
#include "packing/pack.h"

namespace collage {

/// Fills the space, which must be fresh from the target, with elements fitted by their shape: a
/// queue of holes, the most promising first; in each the largest pose that covering spheres find;
/// before it is placed, the exact test of surfaces decides, and by it the instance is grown or
/// shrunk to the last percent. Ends where no element of the least size fits any more.
///
/// Least size: a bounding sphere with the threshold as radius (scaling to-hole), or the smallest
/// scale listed of at least that size. `choose`: largest is by volume; alternate and weighted hold
/// the numbers of instances to the weights within 5 %, and end the packing where no place is left
/// for an element that is behind; an element that has never fitted does not count.
///
/// Linking: rings that would hang in one another are refused (avoid), taken as they come (allow),
/// or preferred to larger ones that do not (seek). Each instance with a ring then is a host:
/// another is fitted through it, and tried before holes of the same size.
///
/// Results depend on input, options and seed alone, not on the number of threads. Throws
/// Interrupted. Cost: some 10 ms an instance with 500 spheres.
Packing pack_by_shape(const ShapeTarget& target, FreeSpace& space,
                      std::span<const ShapeIngredient> ingredients, const PackingOptions& options,
                      Status& status);

}  // namespace collage
