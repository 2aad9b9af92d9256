#pragma once

#include <string>
#include <vector>

namespace collage::bench {

/// A figure held against a baseline: `ratio` is figure ÷ baseline and must not exceed `bar`.
struct PreviewBar {
  std::string name;
  double figure = 0.0;
  std::string unit;
  double baseline = 0.0;
  double ratio = 0.0;
  double bar = 1.0;
  bool holds = false;
};

/// A ball of 300,000 rings of 1,024 faces at 640 x 480, from the meshes to the slowest of three
/// views, in processor seconds: those of building, which one core does, and half of the view's,
/// against two seconds.
std::vector<PreviewBar> preview_bars();

}  // namespace collage::bench
