#include "cli/sweep.h"

#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

#include "base/error.h"

namespace collage {
namespace {

constexpr std::uint64_t most_seeds = 1000;

std::optional<std::uint64_t> seed_in(std::string_view text) {
  std::uint64_t value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_number = result.ec == std::errc() && result.ptr == text.data() + text.size();
  return is_number ? std::optional(value) : std::nullopt;
}

/// Parted at the commas that are in no bracket, brace or quotes.
std::vector<std::string> parted(std::string_view text) {
  std::vector<std::string> parts(1);
  int depth = 0;
  bool is_quoted = false;
  for (const char c : text) {
    is_quoted ^= c == '"';
    if (!is_quoted) {
      depth += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
    }
    if (c == ',' && depth == 0 && !is_quoted) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

std::vector<std::string> range(std::uint64_t first, std::uint64_t last) {
  std::vector<std::string> values;
  for (std::uint64_t n = 0; n <= last - first; ++n) {
    values.push_back(std::to_string(first + n));
  }
  return values;
}

}  // namespace

SweepOption parse_sweep_option(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw Error("'" + assignment + "' sets no option",
                "write it as packing.threshold=0.05,0.03,0.02");
  }
  SweepOption option{assignment.substr(0, equals),
                     parted(std::string_view(assignment).substr(equals + 1))};
  for (const std::string& value : option.values) {
    if (value.empty()) {
      throw Error("a value is missing in '" + assignment + "'",
                  "write it as packing.threshold=0.05,0.03,0.02");
    }
  }
  return option;
}

SweepOption parse_sweep_seeds(const std::string& text) {
  const std::size_t dots = text.find("..");
  if (dots != std::string::npos) {
    const auto first = seed_in(std::string_view(text).substr(0, dots));
    const auto last = seed_in(std::string_view(text).substr(dots + 2));
    if (first && last && *first <= *last && *last - *first < most_seeds) {
      return {"packing.seed", range(*first, *last)};
    }
  } else {
    const std::vector<std::string> seeds = parted(text);
    bool are_numbers = seeds.size() <= most_seeds;
    for (const std::string& seed : seeds) {
      are_numbers = are_numbers && seed_in(seed);
    }
    if (are_numbers) {
      return {"packing.seed", seeds};
    }
  }
  throw Error("'" + text + "' is no range of seeds", "write it as 1..4, or as 1,3,9");
}

std::vector<std::vector<std::string>> combinations(const std::vector<SweepOption>& options) {
  std::vector<std::vector<std::string>> result(1);
  for (const SweepOption& option : options) {
    std::vector<std::vector<std::string>> longer;
    for (const std::vector<std::string>& start : result) {
      for (const std::string& value : option.values) {
        longer.push_back(start);
        longer.back().push_back(option.key + "=" + value);
      }
    }
    result = std::move(longer);
  }
  return result;
}

}  // namespace collage
