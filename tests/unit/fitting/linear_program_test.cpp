#include "fitting/linear_program.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "base/rng.h"

namespace collage {
namespace {

constexpr std::size_t n = LinearProgram::variables;
using Vector = LinearProgram::Vector;

struct Constraint {
  std::array<float, n> coefficients;
  float limit;
};

double dot(const Vector& a, const std::array<float, n>& b) {
  double sum = 0.0;
  for (std::size_t v = 0; v < n; ++v) {
    sum += a[v] * b[v];
  }
  return sum;
}

/// The slow twin, for programs in x₀ and x₁ alone: the best of all points where two of the lines
/// cross.
std::optional<double> best_corner(const std::vector<Constraint>& given, const Vector& objective) {
  std::vector<Constraint> lines = given;
  for (std::size_t v = 0; v < 2; ++v) {
    for (const float sign : {1.0F, -1.0F}) {
      Constraint bound{{}, 1.0F};
      bound.coefficients[v] = sign;
      lines.push_back(bound);
    }
  }
  std::optional<double> best;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t j = i + 1; j < lines.size(); ++j) {
      const auto& [a, s] = lines[i];
      const auto& [b, t] = lines[j];
      const double determinant = double{a[0]} * b[1] - double{a[1]} * b[0];
      if (std::abs(determinant) < 1e-9) {
        continue;
      }
      Vector x{};
      x[0] = (double{s} * b[1] - double{a[1]} * t) / determinant;
      x[1] = (double{a[0]} * t - double{s} * b[0]) / determinant;
      const bool allowed = std::ranges::all_of(lines, [&](const Constraint& line) {
        return dot(x, line.coefficients) <= line.limit + 1e-9;
      });
      const double value = objective[0] * x[0] + objective[1] * x[1];
      if (allowed && (!best || value > *best)) {
        best = value;
      }
    }
  }
  return best;
}

float random(Rng& rng) { return static_cast<float>(2.0 * rng.uniform() - 1.0); }

TEST(LinearProgram, FindsTheBestCornerThatItsSlowTwinFinds) {
  int solved = 0;
  int unsolvable = 0;
  for (std::uint64_t round = 0; round < 500; ++round) {
    Rng rng(3, round);
    LinearProgram program;
    std::vector<Constraint> constraints(1 + rng.below(12));
    for (Constraint& constraint : constraints) {
      constraint.coefficients = {random(rng), random(rng)};
      constraint.limit = 0.6F * random(rng) + 0.2F;
      program.add(constraint.coefficients, constraint.limit);
    }
    program.objective = {random(rng), random(rng)};
    for (std::size_t v = 0; v < 2; ++v) {
      program.lowest[v] = -1.0;
      program.highest[v] = 1.0;
    }
    const auto best = best_corner(constraints, program.objective);
    ASSERT_EQ(program.solve(), best.has_value()) << round;
    if (best) {
      const Vector& x = program.solution();
      EXPECT_NEAR(program.objective[0] * x[0] + program.objective[1] * x[1], *best, 1e-3) << round;
      ++solved;
    } else {
      ++unsolvable;
    }
  }
  EXPECT_GT(solved, 200);
  EXPECT_GT(unsolvable, 20);
}

/// In all eight variables: the solution keeps to the constraints, and no random point that keeps to
/// them is better.
TEST(LinearProgram, IsNotBeatenByRandomPoints) {
  for (std::uint64_t round = 0; round < 50; ++round) {
    Rng rng(4, round);
    LinearProgram program;
    std::vector<Constraint> constraints(40);
    for (Constraint& constraint : constraints) {
      for (float& coefficient : constraint.coefficients) {
        coefficient = random(rng);
      }
      constraint.limit = 0.1F + 0.5F * std::abs(random(rng));
      program.add(constraint.coefficients, constraint.limit);
    }
    for (std::size_t v = 0; v < n; ++v) {
      program.objective[v] = double{random(rng)};
      program.lowest[v] = -0.5;
      program.highest[v] = 0.5;
    }
    ASSERT_TRUE(program.solve());
    const auto value = [&](const Vector& x) {
      double sum = 0.0;
      for (std::size_t v = 0; v < n; ++v) {
        sum += program.objective[v] * x[v];
      }
      return sum;
    };
    for (const Constraint& constraint : constraints) {
      EXPECT_LE(dot(program.solution(), constraint.coefficients), constraint.limit + 2e-5);
    }
    for (int i = 0; i < 2000; ++i) {
      Vector x;
      for (double& part : x) {
        part = 0.5 * double{random(rng)};
      }
      if (std::ranges::all_of(constraints, [&](const Constraint& constraint) {
            return dot(x, constraint.coefficients) <= constraint.limit;
          })) {
        EXPECT_LE(value(x), value(program.solution()) + 1e-4);
      }
    }
  }
}

}  // namespace
}  // namespace collage
