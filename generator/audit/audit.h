#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/status.h"
#include "geometry/instance.h"
#include "geometry/mesh.h"

namespace collage {

/// What is promised of every sculpture, looked at anew. Nothing here is shared with what packs:
/// surfaces are compared triangle by triangle with exact predicates, in the coordinates that
/// world_from_element() gives.
struct Audit {
  struct Pair {
    std::uint32_t first;
    std::uint32_t second;
    /// See penetration_depth(); measured for the first `depths_measured` pairs.
    std::optional<double> depth;
  };
  static constexpr std::size_t depths_measured = 1000;

  /// Instances whose surfaces have a point in common, or one of which has a part inside another.
  /// Where the other is open, so that its inside has no clear end, all the part must be inside.
  std::vector<Pair> overlaps;
  /// Instances whose surface meets the target's, or with a part outside of it; where the target is
  /// open, all of the part.
  std::vector<std::uint32_t> protrusions;
  /// Instances that are not rigid copies: rotation no unit quaternion to 1e-9, or scale not above 0
  /// or not one of those allowed.
  std::vector<std::uint32_t> deformed;

  [[nodiscard]] bool passed() const {
    return overlaps.empty() && protrusions.empty() && deformed.empty();
  }
};

struct AuditInput {
  /// nullptr: the target is not a mesh, and protrusions are not looked for.
  const Mesh* target = nullptr;
  std::vector<const Mesh*> elements;
  /// For each element the scales allowed; empty: any.
  std::vector<std::vector<double>> scales;
  std::span<const Instance> instances;
};

/// Runs on all threads; the result does not depend on their number. Touching counts as overlap.
/// Throws Interrupted where the user stops it.
/// Cost: O(n log n) for n instances, and for each pair whose boxes meet about as many triangle
/// tests as there are triangles where they meet.
Audit audit(const AuditInput& input, Status& status);

}  // namespace collage
