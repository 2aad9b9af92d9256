#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace collage {

/// How the instances' sizes are spread.
struct Sizes {
  double smallest = 0.0;
  double largest = 0.0;
  /// Instances by size, in bins of equal width on a logarithmic scale from `smallest` to `largest`;
  /// one bin where these are the same.
  std::vector<std::uint64_t> histogram;

  /// α of a density ∝ size^-α for sizes from the smallest on, as it fits best: the
  /// maximum-likelihood estimate of Clauset, Shalizi and Newman 2009 ("Power-law distributions in
  /// empirical data", eq. 3.1) with x_min = `smallest`. The number of instances larger than x then
  /// falls as x^(1-α). A sphere packing that is filled on and on as Apollonius did comes to 3.47. A
  /// figure of the spread, not a proof that it is a power law. Nothing where all sizes are the
  /// same.
  struct PowerLaw {
    double exponent = 0.0;
    /// Standard error, (α - 1) / √n (eq. 3.2).
    double error = 0.0;
  };
  std::optional<PowerLaw> power_law;
};

/// Of sizes above 0; nothing where there are none.
std::optional<Sizes> size_distribution(std::span<const double> sizes, std::size_t bins = 20);

}  // namespace collage
