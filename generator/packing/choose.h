#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/rng.h"
#include "packing/options.h"

namespace collage {

/// An element at a scale.
struct Choice {
  std::uint32_t element = 0;
  double scale = 1.0;
};

/// Selects which element fills a hole (Muhm 2011, III.3.1).
class Chooser {
 public:
  struct Candidate {
    /// Radius of the element's smallest enclosing sphere at scale 1.
    double size = 1.0;
    /// The scales allowed where scaling is fixed.
    std::vector<double> scales{1.0};
    double weight = 1.0;
    /// The stretch of the target's width that it is placed in: 0 at its left, -x, 1 at its right.
    double left = 0.0;
    double right = 1.0;
  };

  Chooser(std::vector<Candidate> candidates, const PackingOptions& options)
      : candidates_(std::move(candidates)), scaling_(options.scaling), choose_(options.choose) {}

  /// For a hole of the given radius, `across` the target's width as Candidate::left; nothing where
  /// no element of that place is small enough. `placed` instances are there already; ties and
  /// weights are decided by `rng`.
  [[nodiscard]] std::optional<Choice> choose(double radius, std::size_t placed, Rng& rng,
                                             double across = 0.5) const;
  /// Whether some element is small enough, wherever it is placed.
  [[nodiscard]] bool fits(double radius) const;

 private:
  [[nodiscard]] std::optional<double> best_scale(const Candidate& candidate, double radius) const;
  [[nodiscard]] std::uint32_t pick_largest(const std::vector<Choice>& fitting, Rng& rng) const;
  [[nodiscard]] std::uint32_t pick_next(const std::vector<Choice>& fitting,
                                        std::size_t placed) const;
  [[nodiscard]] std::uint32_t pick_weighted(const std::vector<Choice>& fitting, Rng& rng) const;

  std::vector<Candidate> candidates_;
  Scaling scaling_;
  Choose choose_;
};

}  // namespace collage
