#pragma once

#include <string>
#include <vector>

namespace collage {

/// An option and the values that a sweep tries of it.
struct SweepOption {
  std::string key;
  std::vector<std::string> values;
};

/// "packing.threshold=0.05,0.03": commas inside brackets, braces or quotes part nothing, so that a
/// list is written [1, 0.5]. Throws Error where there is no key or an empty value.
SweepOption parse_sweep_option(const std::string& assignment);

/// "1..4", "7" or "1,3,9", as the option packing.seed. Throws Error for anything else, and for more
/// than 1,000 seeds.
SweepOption parse_sweep_seeds(const std::string& text);

/// All combinations as assignments "key=value", one an option; the last option changes fastest.
std::vector<std::vector<std::string>> combinations(const std::vector<SweepOption>& options);

}  // namespace collage
