#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "audit/instance_index.h"
#include "audit/target_shape.h"
#include "base/status.h"

namespace collage {

/// How much of the target the sculpture fills, in shares from 0 to 1.
struct Fill {
  /// Volume of the instances' solids ÷ volume of the target's (Solid::volume()).
  double by_volume = 0.0;

  /// Points spread evenly in the target, and how many of them an instance holds.
  struct Sample {
    std::uint64_t points = 0;
    std::uint64_t filled = 0;

    /// Nothing where there are no points.
    [[nodiscard]] std::optional<double> share() const;
    /// Standard deviation of the share, of points at random; these, one in each cell of a grid,
    /// deviate less.
    [[nodiscard]] std::optional<double> deviation() const;
  };
  Sample by_points;

  /// How it grew: after so many instances in the order of placement the fill by volume was so much.
  /// Rising, some hundred steps at most, evenly spread on a scale of logarithms.
  struct Step {
    std::uint64_t instances = 0;
    double by_volume = 0.0;
  };
  std::vector<Step> growth;

  /// By depth below the surface, in tenths of `greatest_depth`, the outermost first. A point's
  /// depth is its distance to the nearest triangle of the target.
  std::array<Sample, 10> by_shell;
  /// Of any point, as a fraction of the target's longest side.
  double greatest_depth = 0.0;
};

struct FillOptions {
  /// About as many points are in the target; fewer in one that is very thin for its box.
  std::size_t points = 100000;
};

/// Always uses the same points for the same target. Nothing where that has no volume. Runs on all
/// threads; throws Interrupted. Cost: O(log n) a point for n instances.
std::optional<Fill> fill(const TargetShape& target, const InstanceIndex& sculpture,
                         const FillOptions& options, Status& status);

}  // namespace collage
