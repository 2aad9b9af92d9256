#pragma once

#include <cstdint>
#include <optional>

#include "audit/instance_index.h"
#include "base/status.h"

namespace collage {

/// Which instances hang in one another like the links of a chain.
struct Links {
  std::uint64_t pairs = 0;
  /// Share of the instances that hang in another.
  double linked_share = 0.0;
  /// The largest linking number of a pair, its sign aside.
  int largest_number = 0;
};

/// By linking numbers of the elements' handle_loops(). Nothing where no element has a handle, or
/// where there are no instances; elements of more than four handles are left out. Runs on all
/// threads; throws Interrupted.
/// Cost: for each pair whose boxes meet the product of the lengths of its loops.
std::optional<Links> find_links(const InstanceIndex& sculpture, Status& status);

}  // namespace collage
