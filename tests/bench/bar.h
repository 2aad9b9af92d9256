#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geometry/mesh.h"

namespace collage::bench {

/// One figure held against another of the same run.
struct Bar {
  std::string name;
  double figure = 0.0;
  std::string unit;
  double baseline = 0.0;
  double ratio = 0.0;
  enum class Side { at_least, at_most } side = Side::at_least;
  double bar = 0.0;

  [[nodiscard]] bool holds() const { return side == Side::at_least ? ratio >= bar : ratio <= bar; }
};

/// Bars measured together; a group whose name holds the filter is run.
struct Group {
  std::string name;
  std::function<std::vector<Bar>()> run;
  /// The meshes of others are needed.
  enum class Meshes { own, field } meshes = Meshes::own;
};

// Each in the file of its name.
std::vector<Group> update_bars();
std::vector<Group> scaling_bars();
std::vector<Group> signed_distance_bars();
std::vector<Group> preview_bars();

/// A mesh from $COLLAGE_FIELD_MESHES, set right.
Mesh field_mesh(const std::string& name);

/// Processor time of all threads, which others on the machine hardly disturb.
double processor_seconds();

/// Processor seconds of `work` on so many threads.
double measure(std::size_t threads, const std::function<void()>& work);

}  // namespace collage::bench
