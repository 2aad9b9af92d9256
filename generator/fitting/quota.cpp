#include "fitting/quota.h"

#include <algorithm>
#include <cmath>

namespace collage {

std::vector<double> Quota::wanted(const std::vector<char>& available) const {
  std::vector<double> numbers(weights_.size(), 0.0);
  double sum = 0.0;
  for (std::size_t e = 0; e < weights_.size(); ++e) {
    numbers[e] = counts(available, e) ? weights_[e] : 0.0;
    sum += numbers[e];
  }
  for (double& number : numbers) {
    number *= sum > 0.0 ? static_cast<double>(total_ + 1) / sum : 0.0;
  }
  return numbers;
}

std::optional<std::uint32_t> Quota::farthest_behind(const std::vector<char>& available) const {
  const std::vector<double> numbers = wanted(available);
  std::optional<std::uint32_t> best;
  double farthest = 0.0;
  for (std::uint32_t e = 0; e < weights_.size(); ++e) {
    const double behind = numbers[e] - static_cast<double>(counts_[e]);
    if (available[e] != 0 && weights_[e] > 0.0 && (!best || behind > farthest)) {
      best = e;
      farthest = behind;
    }
  }
  return best;
}

std::optional<std::uint32_t> Quota::next(const std::vector<char>& available) const {
  const auto best = farthest_behind(available);
  const std::vector<double> numbers = wanted(available);
  for (std::uint32_t e = 0; best && e < weights_.size(); ++e) {
    const double number = static_cast<double>(counts_[e]) + (e == *best ? 1.0 : 0.0);
    if (std::abs(number - numbers[e]) > std::max(1.0, tolerance * numbers[e])) {
      return std::nullopt;
    }
  }
  return best;
}

}  // namespace collage
