#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace collage {

/// How the kinds are mixed; an instance's kind is its element.
struct Kinds {
  /// Instances by kind, and the same as shares of all.
  std::vector<std::uint64_t> counts;
  std::vector<double> shares;

  /// Whether instances stand next to their own kind more often than by chance, which is: had the
  /// same places been given their kinds at random. "Next to" is the instance whose centre is
  /// nearest.
  struct Clustering {
    /// Instances next to one of their own kind, as a share of all, and what chance gives.
    double same = 0.0;
    double by_chance = 0.0;
    /// same / by_chance: 1 as by chance, more where kinds cluster, less where they avoid their own.
    double ratio = 0.0;
    /// (same - by_chance) ÷ the standard deviation that chance gives `same`, by the exact moments
    /// of random labelling (Dixon 1994, "Testing spatial segregation using a nearest-neighbor
    /// contingency table"). Beyond ±2 chance is unlikely, beyond ±3 very.
    /// 0 where every labelling comes to the same.
    double z_score = 0.0;
  };
  /// Nothing where there are fewer than four instances, or one kind only, or all of different
  /// kinds.
  std::optional<Clustering> clustering;
};

/// `kinds` gives for each centre an index below `kind_count`. Cost: O(n log n).
Kinds mix_of_kinds(std::span<const std::uint32_t> kinds, std::span<const dvec3> centers,
                   std::size_t kind_count);

}  // namespace collage
