#pragma once

#include <cstdint>

namespace collage {

enum class Scaling { fixed, to_hole };
enum class Choose { largest, alternate, weighted };
enum class Fit { sphere };
enum class Distance { exact, vertices };

/// What the user may choose about packing; the meaning of each, its unit and range stand in the
/// options table (scene/options_table.cpp). Lengths are fractions of the target's longest side.
struct PackingOptions {
  double threshold = 0.02;
  Scaling scaling = Scaling::fixed;
  Choose choose = Choose::largest;
  Fit fit = Fit::sphere;
  Distance distance = Distance::exact;
  double spacing = 0.0;
  std::uint64_t seed = 1;
};

}  // namespace collage
