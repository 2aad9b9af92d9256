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
  /// What the bar is set for.
  enum class Held { ratio, figure } held = Held::ratio;
  /// False where the figure was come by at the price of a promise.
  bool sound = true;

  [[nodiscard]] bool holds() const {
    const double value = held == Held::ratio ? ratio : figure;
    return sound && (side == Side::at_least ? value >= bar : value <= bar);
  }
};

/// Bars measured together; a group whose name holds the filter is run.
struct Group {
  std::string name;
  std::function<std::vector<Bar>()> run;
  /// The meshes of others are needed: those in $COLLAGE_FIELD_MESHES, or sweethome3d-furniture in
  /// $COLLAGE_MESHES.
  enum class Meshes { own, field, furniture } meshes = Meshes::own;
  /// What takes many minutes is run only where the filter is all of its name.
  enum class Named { in_part, in_full } named = Named::in_part;
  /// Why it cannot be run at all; empty: it can.
  std::string missing{};
};

// Each in the file of its name.
std::vector<Group> update_bars();
std::vector<Group> scaling_bars();
std::vector<Group> signed_distance_bars();
std::vector<Group> sphere_bars();
std::vector<Group> memory_bars();
std::vector<Group> preview_bars();
std::vector<Group> shape_bars();

/// $COLLAGE_FIELD_MESHES, or empty.
std::string field_folder();

/// A mesh from there, set right.
Mesh field_mesh(const std::string& name);

/// Processor time of all threads, which others on the machine hardly disturb.
double processor_seconds();

/// Processor seconds of `work` on so many threads.
double measure(std::size_t threads, const std::function<void()>& work);

}  // namespace collage::bench
