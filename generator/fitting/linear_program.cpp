#include "fitting/linear_program.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

void LinearProgram::grow() {
  const std::size_t capacity = std::max<std::size_t>(64, 2 * limits_.size());
  for (std::vector<float>& column : columns_) {
    column.resize(capacity);
  }
  limits_.resize(capacity);
  excess_.resize(capacity);
}

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
  float* excess = excess_.data();
  for (std::size_t c = 0; c < count_; ++c) {
    excess[c] = -limits_[c];
  }
  for (std::size_t v = 0; v < variables; ++v) {
    const auto x = static_cast<float>(x_[v]);
    const float* column = columns_[v].data();
    for (std::size_t c = 0; c < count_; ++c) {
      excess[c] += column[c] * x;
    }
  }
  auto worst = static_cast<float>(tolerance);
  std::size_t found = count_;
  for (std::size_t c = 0; c < count_; ++c) {
    if (excess[c] > worst) {
      worst = excess[c];
      found = c;
    }
  }
  double most = worst;
  bool violated = found < count_;
  if (violated) {
    for (std::size_t v = 0; v < variables; ++v) {
      entering.normal[v] = columns_[v][found];
    }
    entering.limit = limits_[found];
  }
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
