#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace collage {

/// Holds the numbers of instances of several elements to their weights.
class Quota {
 public:
  /// How far a number may stray from what is asked for, as a share of it, or by one instance.
  static constexpr double tolerance = 0.05;

  /// Weights are 0 and up.
  explicit Quota(std::span<const double> weights)
      : weights_(weights.begin(), weights.end()), counts_(weights.size()) {}

  void count(std::uint32_t element) {
    ++counts_[element];
    ++total_;
  }
  /// The element that is farthest behind of those that are `available`; nothing where none is.
  /// Elements without an instance that are not available do not count.
  [[nodiscard]] std::optional<std::uint32_t> farthest_behind(
      const std::vector<char>& available) const;
  /// The same, or nothing where one more of it would take the mix out of the tolerance.
  [[nodiscard]] std::optional<std::uint32_t> next(const std::vector<char>& available) const;

 private:
  [[nodiscard]] bool counts(const std::vector<char>& available, std::size_t element) const {
    return available[element] != 0 || counts_[element] > 0;
  }
  /// How many there should be of each once there is one more.
  [[nodiscard]] std::vector<double> wanted(const std::vector<char>& available) const;

  std::vector<double> weights_;
  std::vector<std::uint64_t> counts_;
  std::uint64_t total_ = 0;
};

}  // namespace collage
