#pragma once

#include <cstdint>
#include <vector>

#include "scene/composition.h"

namespace collage {

/// A few instances close to each other, or a few smaller neighbourhoods, and a box that holds them.
struct Neighbourhood {
  Box box;
  /// At most 8; empty where there are `instances`.
  std::vector<Neighbourhood> parts;
  /// At most 16 indices into Composition::instances, ascending.
  std::vector<std::uint32_t> instances;
};

/// All instances as a tree of neighbourhoods, halved three times over at the median of the longest
/// side of what their centres span. The boxes are those of the elements' boxes as they lie, wide
/// enough for vertices that are rounded to float. A tree without instances is one empty leaf.
/// The same on every machine. Cost: O(n log n).
Neighbourhood neighbourhoods(const Composition& composition);

}  // namespace collage
