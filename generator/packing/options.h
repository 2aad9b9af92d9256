#pragma once

#include <cstdint>

namespace collage {

enum class Scaling { fixed, to_hole };
enum class Choose { largest, alternate, weighted };
enum class Fit { sphere, shape };
enum class Linking { avoid, allow, seek };
enum class Distance { exact, vertices };

/// What the user may choose about packing; the meaning of each, its unit and range stand in the
/// options table (scene/options_table.cpp). Lengths are fractions of the target's longest side.
struct PackingOptions {
  double threshold = 0.02;
  /// 0: as `threshold`.
  double threshold_core = 0.0;
  double largest = 1.0;
  Scaling scaling = Scaling::fixed;
  Choose choose = Choose::largest;
  Fit fit = Fit::shape;
  Linking linking = Linking::allow;
  Distance distance = Distance::exact;
  double spacing = 0.0;
  bool climb = false;
  std::uint64_t seed = 1;
};

}  // namespace collage
