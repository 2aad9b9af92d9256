#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "audit/instance_index.h"
#include "audit/target_shape.h"
#include "base/status.h"

namespace collage {

/// How far the target's surface is from the sculpture. Lengths are fractions of the target's
/// longest side.
struct SurfaceDistance {
  std::uint64_t points = 0;
  double mean = 0.0;
  /// 95 % of the points are as near or nearer.
  double p95 = 0.0;
  /// Share of the points that are as near as SurfaceDistanceOptions::within or nearer.
  double share_within = 0.0;
  /// Points by distance, in bins of `bin_width` from 0 to the largest found.
  std::vector<std::uint64_t> histogram;
  double bin_width = 0.0;
};

struct SurfaceDistanceOptions {
  std::size_t points = 20000;
  double within = 0.02;
  std::size_t bins = 20;
};

/// From points spread evenly over the target's surface (spread_over_surface()) to the nearest
/// instance's surface, each right to 10⁻⁵ of the longest side. Of targets made of sheets that cross
/// or lie inside each other only points count where the solid ends, the winding number passing one
/// half from side to side, so that there may be fewer points than asked for.
/// Nothing where there are no instances or no such points. Runs on all threads; throws
/// Interrupted. Cost: O(log n) a point for n instances.
std::optional<SurfaceDistance> surface_distance(const TargetShape& target,
                                                const InstanceIndex& sculpture,
                                                const SurfaceDistanceOptions& options,
                                                Status& status);

}  // namespace collage
