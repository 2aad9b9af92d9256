#pragma once

#include <span>
#include <vector>

#include "base/status.h"
#include "geometry/instance.h"
#include "packing/clearance_field.h"
#include "packing/options.h"
#include "packing/placer.h"

namespace collage {

struct Packing {
  std::vector<Instance> instances;
  /// False where Status::finish_requested() ended it before the space was full.
  bool complete = true;
  glm::ivec3 voxels{0};
  std::size_t voxels_inside_target = 0;
  std::size_t voxels_inside_instances = 0;
  /// Radius of the largest hole left at a voxel, in world units.
  double largest_hole = 0.0;
  double place_seconds = 0.0;
  double update_seconds = 0.0;

  [[nodiscard]] double fill_by_voxels() const {
    return voxels_inside_target == 0 ? 0.0
                                     : static_cast<double>(voxels_inside_instances) /
                                           static_cast<double>(voxels_inside_target);
  }
};

/// Fills the field with elements, biggest first (Muhm 2011, Fig. 9), until the largest hole is
/// smaller than the threshold or than every element. The field, which must be fresh from the
/// target, is left with the clearances between the instances. Ends after any instance but none
/// where it is asked to finish. Throws Interrupted where the user stops it. Cost: a small multiple
/// of the number of voxels, however many elements, times a query each.
Packing pack(const Target& target, ClearanceField& field, std::span<const Ingredient> ingredients,
             const PackingOptions& options, Status& status);

/// Share of the target's volume that the instances take, by the volumes of the solids.
double fill(const Target& target, std::span<const Ingredient> ingredients,
            std::span<const Instance> instances);

}  // namespace collage
