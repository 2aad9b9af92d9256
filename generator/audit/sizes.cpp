#include "audit/sizes.h"

#include <algorithm>
#include <cmath>

namespace collage {

std::optional<Sizes> size_distribution(std::span<const double> sizes, std::size_t bins) {
  if (sizes.empty()) {
    return std::nullopt;
  }
  const auto [smallest, largest] = std::minmax_element(sizes.begin(), sizes.end());
  Sizes result{*smallest, *largest, {}, {}};
  const double range = std::log(*largest / *smallest);
  result.histogram.resize(range > 0.0 ? bins : 1);
  const auto bin_count = static_cast<double>(result.histogram.size());
  double sum = 0.0;
  for (const double size : sizes) {
    const double above = std::log(size / *smallest);
    const double bin = range > 0.0 ? above / range * bin_count : 0.0;
    ++result.histogram[static_cast<std::size_t>(std::min(bin, bin_count - 1.0))];
    sum += above;
  }
  if (sum > 0.0) {
    const auto n = static_cast<double>(sizes.size());
    result.power_law = {1.0 + n / sum, n / sum / std::sqrt(n)};
  }
  return result;
}

}  // namespace collage
