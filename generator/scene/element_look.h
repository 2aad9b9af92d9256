#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "scene/composition.h"

namespace collage {

/// The materials that an element is shown with; at least one.
struct ElementLook {
  std::vector<Material> materials;
  /// Whether each triangle has its own, Mesh::triangle_materials; else all have the first.
  enum class Assignment { all_the_first, by_triangle } assignment = Assignment::all_the_first;
};

/// The scene's colour, else the mesh file's materials, else the colour of a small palette that the
/// element's index picks.
ElementLook look_of(const Composition::Element& element, std::size_t index);

/// Linear-light RGB, 0 to 1, of "#rrggbb" in sRGB (IEC 61966-2-1).
dvec3 linear_color(const std::string& hex);

}  // namespace collage
