#pragma once

#include <span>

#include "packing/pack.h"

namespace collage::test {

/// Accounts for instance `id`, which fills `hole`, with one exact query for each voxel in reach:
/// the slow twin of update(). Returns the number of voxels flagged. On all threads.
std::size_t exact_update(ClearanceField& field, const Surfaces& surfaces, SurfaceId id,
                         const Hole& hole);

/// One hole after the other with exact_update(): the slow twin of pack(), the same to the last bit.
Packing exact_pack(const Target& target, ClearanceField& field,
                   std::span<const Ingredient> ingredients, const PackingOptions& options);

}  // namespace collage::test
