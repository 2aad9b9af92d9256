#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace collage {

/// For each point the index of the one nearest to it, itself aside; of equally near ones the first.
/// There are at least two points. Runs on all threads. Cost: O(n log n).
std::vector<std::uint32_t> nearest_neighbours(std::span<const dvec3> points);

}  // namespace collage
