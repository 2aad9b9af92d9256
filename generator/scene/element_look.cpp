#include "scene/element_look.h"

#include <array>
#include <cassert>
#include <charconv>

#include "geometry/color.h"

namespace collage {
namespace {

/// Warm white, terracotta, teal, ochre, sage, slate blue, plum, sand.
constexpr std::array palette{"#e9dfcd", "#c4573a", "#2b7f86", "#d8a23c",
                             "#8b9c63", "#4d6c91", "#7b4b69", "#c7b08a"};

ElementLook plain(const std::string& color) {
  Material material;
  material.color = linear_color(color);
  return {{material}, ElementLook::Assignment::all_the_first};
}

}  // namespace

dvec3 linear_color(const std::string& hex) {
  assert(hex.size() == 7 && hex[0] == '#');
  dvec3 color;
  for (int channel = 0; channel < 3; ++channel) {
    const char* digits = hex.data() + 1 + 2 * channel;
    unsigned value = 0;
    std::from_chars(digits, digits + 2, value, 16);
    color[channel] = value / 255.0;
  }
  return linear_from_srgb(color);
}

ElementLook look_of(const Composition::Element& element, std::size_t index) {
  if (!element.color.empty()) {
    return plain(element.color);
  }
  const Mesh& mesh = element.mesh;
  if (mesh.materials.empty()) {
    return plain(palette[index % palette.size()]);
  }
  return {mesh.materials, mesh.triangle_materials.empty() ? ElementLook::Assignment::all_the_first
                                                          : ElementLook::Assignment::by_triangle};
}

}  // namespace collage
