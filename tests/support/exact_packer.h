#pragma once

#include <functional>
#include <optional>
#include <span>

#include "packing/pack.h"

namespace collage::test {

/// Distance of a point to an element in its unit frame; nothing where that is not below a limit.
using ExactDistance =
    std::function<std::optional<double>(const Element&, const dvec3& unit, double limit)>;

/// By the element's own index, without a hint.
std::optional<double> indexed_distance(const Element& element, const dvec3& unit, double limit);

/// Accounts for instance `id`, which fills `hole`, with one exact query for each voxel in reach:
/// the slow twin of update(). Returns the number of voxels flagged. On all threads.
std::size_t exact_update(ClearanceField& field, const Surfaces& surfaces, SurfaceId id,
                         const Hole& hole, const ExactDistance& distance = indexed_distance);

/// One hole after the other with exact_update(): the slow twin of pack(), the same to the last bit.
Packing exact_pack(const Target& target, ClearanceField& field,
                   std::span<const Ingredient> ingredients, const PackingOptions& options,
                   const ExactDistance& distance = indexed_distance);

}  // namespace collage::test
