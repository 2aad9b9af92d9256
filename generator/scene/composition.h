#pragma once

#include <span>
#include <string>
#include <vector>

#include "geometry/instance.h"
#include "geometry/mesh.h"
#include "scene/finish.h"

namespace collage {

/// A sculpture together with its meshes, as the exporters take it. The meshes and instances belong
/// to somebody else and must outlive it.
struct Composition {
  struct Element {
    std::string name;
    const Mesh& mesh;
    /// "#rrggbb" in sRGB, in place of the mesh's materials; empty for none.
    std::string color = {};
    Finish finish = Finish::automatic;
  };

  std::string name;
  /// Program and version, "collage 0.1.0".
  std::string made_by;
  std::vector<Element> elements;
  /// In the order of placement; each refers to one of `elements`.
  std::span<const Instance> instances;
  /// nullptr where the target is a grid of distances.
  const Mesh* target = nullptr;
  Box target_box;
  /// Shown as they stand, whatever stage or kind of element is.
  std::vector<Element> props = {};
};

}  // namespace collage
