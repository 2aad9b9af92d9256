#pragma once

#include <cstdint>
#include <optional>

#include "audit/instance_index.h"
#include "base/status.h"

namespace collage {

/// How the instances hang together. Two of them touch where their surfaces come within a gap; a
/// cluster is a set of instances that hang together by touching ones.
struct Contacts {
  /// The gap, in world units.
  double gap = 0.0;
  std::uint64_t clusters = 0;
  /// Shares of the instances: those that touch no other, and those in the largest cluster.
  double floating_share = 0.0;
  double largest_cluster_share = 0.0;
};

/// Nothing where there are no instances. Runs on all threads; the result does not depend on their
/// number. Throws Interrupted.
/// Cost: O(n log n) for n instances, and one test of surfaces for about each pair of clusters that
/// an instance lies between.
std::optional<Contacts> contacts(const InstanceIndex& sculpture, double gap, Status& status);

}  // namespace collage
