#include "fitting/linear_program.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace collage {
namespace {

constexpr double tolerance = 1e-5;

double dot(const LinearProgram::Vector& a, const LinearProgram::Vector& b) {
  double sum = 0.0;
  for (std::size_t v = 0; v < a.size(); ++v) {
    sum += a[v] * b[v];
  }
  return sum;
}

}  // namespace

void LinearProgram::start_in_best_corner() {
  for (std::size_t v = 0; v < variables; ++v) {
    const bool rising = objective[v] >= 0.0;
    x_[v] = rising ? highest[v] : lowest[v];
    prices_[v] = std::abs(objective[v]);
    edges_[v].fill(0.0);
    edges_[v][v] = rising ? 1.0 : -1.0;
  }
}

bool LinearProgram::find_most_violated(Entering& entering) {
  std::array<Four, variables> x;
  for (std::size_t v = 0; v < variables; ++v) {
    x[v] = all_four(static_cast<float>(x_[v]));
  }
  Four greatest = all_four(static_cast<float>(tolerance));
  const std::size_t blocks = (count_ + four_lanes - 1) / four_lanes;
  for (Block& block : std::span(blocks_).first(blocks)) {
    Four excess = -block.limits;
    for (std::size_t v = 0; v < variables; ++v) {
      excess += block.coefficients[v] * x[v];
    }
    block.excess = excess;
    greatest = larger(excess, greatest);
  }
  const float worst = std::max({greatest[0], greatest[1], greatest[2], greatest[3]});
  bool violated = worst > static_cast<float>(tolerance);
  if (violated) {
    std::size_t found = 0;
    while (blocks_[found / four_lanes].excess[found % four_lanes] != worst) {
      ++found;
    }
    const Block& block = blocks_[found / four_lanes];
    for (std::size_t v = 0; v < variables; ++v) {
      entering.normal[v] = block.coefficients[v][found % four_lanes];
    }
    entering.limit = block.limits[found % four_lanes];
  }
  double most = worst;
  for (std::size_t v = 0; v < variables; ++v) {
    for (const double sign : {1.0, -1.0}) {
      const double limit = sign > 0.0 ? highest[v] : -lowest[v];
      if (sign * x_[v] - limit > most) {
        most = sign * x_[v] - limit;
        violated = true;
        entering.normal.fill(0.0);
        entering.normal[v] = sign;
        entering.limit = limit;
      }
    }
  }
  return violated;
}

bool LinearProgram::pivot(const Entering& entering) {
  constexpr double smallest_pivot = 1e-7;
  Vector weights;
  double best = std::numeric_limits<double>::infinity();
  std::size_t leaving = variables;
  for (std::size_t b = 0; b < variables; ++b) {
    weights[b] = dot(entering.normal, edges_[b]);
    if (weights[b] > smallest_pivot && prices_[b] / weights[b] < best) {
      best = prices_[b] / weights[b];
      leaving = b;
    }
  }
  if (leaving == variables) {
    return false;
  }
  const double step = prices_[leaving] / weights[leaving];
  for (double& part : edges_[leaving]) {
    part /= weights[leaving];
  }
  for (std::size_t b = 0; b < variables; ++b) {
    if (b != leaving) {
      prices_[b] = std::max(0.0, prices_[b] - step * weights[b]);
      for (std::size_t v = 0; v < variables; ++v) {
        edges_[b][v] -= weights[b] * edges_[leaving][v];
      }
    }
  }
  prices_[leaving] = step;
  const double distance = entering.limit - dot(entering.normal, x_);
  for (std::size_t v = 0; v < variables; ++v) {
    x_[v] += distance * edges_[leaving][v];
  }
  return true;
}

bool LinearProgram::solve() {
  constexpr int most_pivots = 200;
  start_in_best_corner();
  Entering entering{};
  for (int i = 0; i < most_pivots; ++i) {
    if (!find_most_violated(entering)) {
      return true;
    }
    if (!pivot(entering)) {
      return false;
    }
  }
  return false;
}

}  // namespace collage
