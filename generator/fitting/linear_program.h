#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "geometry/four.h"

namespace collage {

/// A linear program with few variables and many constraints: maximise objective · x over
/// lowest ≤ x ≤ highest with coefficients · x ≤ limit for each constraint.
///
/// Solved by the dual simplex method: from the corner of the box that is best without constraints,
/// the most violated constraint enters in place of the one that the ratio test frees (Chvátal 1983,
/// "Linear Programming", ch. 10; bounds are constraints like any other). Constraints are float,
/// the basis is double. Cost: one pass over all constraints a pivot, of which there are about as
/// many as variables, times two. Allocates only where more constraints come than ever before.
class LinearProgram {
 public:
  static constexpr std::size_t variables = 8;
  using Vector = std::array<double, variables>;

  Vector objective{};
  Vector lowest{};
  Vector highest{};

  void clear() { count_ = 0; }
  [[nodiscard]] std::size_t count() const { return count_; }
  void add(const std::array<float, variables>& coefficients, float limit) {
    const std::size_t index = count_ / four_lanes;
    const std::size_t lane = count_ % four_lanes;
    if (index == blocks_.size()) {
      blocks_.emplace_back();
    }
    Block& block = blocks_[index];
    if (lane == 0) {
      // What the lanes yet to come have is kept by any x.
      block.limits = all_four(std::numeric_limits<float>::infinity());
    }
    for (std::size_t v = 0; v < variables; ++v) {
      block.coefficients[v][lane] = coefficients[v];
    }
    block.limits[lane] = limit;
    ++count_;
  }

  /// False where nothing satisfies all constraints to 1e-5, or rounding stands in the way.
  bool solve();
  /// The best x, after solve() has succeeded.
  [[nodiscard]] const Vector& solution() const { return x_; }

 private:
  struct Entering {
    Vector normal;
    double limit;
  };
  /// Four constraints, and by how much x violates them.
  struct Block {
    std::array<Four, variables> coefficients{};
    Four limits{};
    Four excess{};
  };
  void start_in_best_corner();
  /// False where no constraint is violated.
  bool find_most_violated(Entering& entering);
  /// False where the program has no solution.
  bool pivot(const Entering& entering);

  std::size_t count_ = 0;
  std::vector<Block> blocks_;
  Vector x_{};
  /// For each constraint of the basis how x moves, per unit of its limit, along all others.
  std::array<Vector, variables> edges_{};
  /// And how much the objective gains.
  Vector prices_{};
};

}  // namespace collage
