#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace collage {

/// A sculpture as Muhm 2011 reports it: Table I (voxels, elements, faces of an element, minutes to
/// assemble on a 2.4 GHz Core 2 Duo) and Table II (share of the target's voxels filled).
struct ThesisSculpture {
  /// The scene that is ours.
  std::string_view scene;
  std::array<int, 3> voxels;
  std::optional<int> elements;
  std::string_view faces;
  std::optional<double> minutes;
  double fill_percent;
};

/// In the order of Table II.
std::span<const ThesisSculpture> thesis_sculptures();

}  // namespace collage
