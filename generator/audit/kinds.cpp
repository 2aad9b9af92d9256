#include "audit/kinds.h"

#include <cmath>

#include "geometry/nearest_neighbours.h"

namespace collage {
namespace {

/// n (n-1) … (n-k+1): the ways to draw k of n one after the other.
double draws(double n, int k) {
  double product = 1.0;
  for (int i = 0; i < k; ++i) {
    product *= n - i;
  }
  return product;
}

/// Chances that things drawn from all instances are of the same kind.
struct Chances {
  double pair = 0.0;
  double three = 0.0;
  /// Two pairs without a common instance, each of one kind.
  double two_pairs = 0.0;

  explicit Chances(std::span<const std::uint64_t> counts) {
    double n = 0.0;
    double pairs = 0.0;
    double squared_pairs = 0.0;
    double threes = 0.0;
    double fours = 0.0;
    for (const std::uint64_t count : counts) {
      const auto c = static_cast<double>(count);
      n += c;
      pairs += draws(c, 2);
      squared_pairs += draws(c, 2) * draws(c, 2);
      threes += draws(c, 3);
      fours += draws(c, 4);
    }
    pair = pairs / draws(n, 2);
    three = threes / draws(n, 3);
    two_pairs = (fours + pairs * pairs - squared_pairs) / draws(n, 4);
  }
};

/// How the arrows from each instance to its nearest neighbour hang together.
struct Arrows {
  /// Ordered pairs of arrows between the same two instances, and of those with one in common.
  double opposite = 0.0;
  double linked = 0.0;

  explicit Arrows(std::span<const std::uint32_t> nearest) {
    std::vector<double> arriving(nearest.size());
    for (std::size_t i = 0; i < nearest.size(); ++i) {
      arriving[nearest[i]] += 1.0;
      const bool mutual = nearest[nearest[i]] == i;
      opposite += mutual ? 1.0 : 0.0;
      linked += mutual ? 0.0 : 2.0;  // this arrow and the one that goes on from its end
    }
    for (const double count : arriving) {
      linked += draws(count, 2);
    }
  }
};

}  // namespace

Kinds mix_of_kinds(std::span<const std::uint32_t> kinds, std::span<const dvec3> centers,
                   std::size_t kind_count) {
  const auto n = static_cast<double>(kinds.size());
  Kinds result;
  result.counts.resize(kind_count);
  for (const std::uint32_t kind : kinds) {
    ++result.counts[kind];
  }
  for (const std::uint64_t count : result.counts) {
    result.shares.push_back(kinds.empty() ? 0.0 : static_cast<double>(count) / n);
  }
  if (kinds.size() < 4) {
    return result;
  }
  const std::vector<std::uint32_t> nearest = nearest_neighbours(centers);
  const Chances chances(result.counts);
  const Arrows arrows(nearest);
  double same = 0.0;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    same += kinds[nearest[i]] == kinds[i] ? 1.0 : 0.0;
  }
  const double expected = n * chances.pair;
  const double apart = n * (n - 1.0) - arrows.opposite - arrows.linked;
  const double variance = (n + arrows.opposite) * chances.pair + arrows.linked * chances.three +
                          apart * chances.two_pairs - expected * expected;
  if (chances.pair > 0.0 && chances.pair < 1.0) {
    const bool varies = variance > 1e-9;  // else rounding alone is left of it
    result.clustering = {same / n, chances.pair, same / expected,
                         varies ? (same - expected) / std::sqrt(variance) : 0.0};
  }
  return result;
}

}  // namespace collage
