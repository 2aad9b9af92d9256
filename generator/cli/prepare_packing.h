#pragma once

#include <functional>
#include <span>
#include <vector>

#include "base/status.h"
#include "packing/pack.h"
#include "scene/scene.h"

namespace collage {

/// What there is to pack. All that it refers to must outlive the packing.
struct PackingInput {
  const Target& target;
  /// The target's mesh; empty where it is a grid of distances.
  const Mesh& target_mesh;
  std::span<const Ingredient> ingredients;
  /// The ingredients' meshes.
  std::vector<const Mesh*> meshes;
};

/// Prepares all that packing takes, by sphere or by shape as the scene says, and gives the packing
/// itself, to be run once. Where it is asked to finish before the shapes of all elements are
/// measured it leaves the last ones out. Throws as ClearanceField, FreeSpace, pack() and
/// pack_by_shape() do, and Error where it would take more than memory_to_take().
std::function<Packing(Status&)> prepare_packing(const Scene& scene, const PackingInput& input,
                                                Status& status);

}  // namespace collage
