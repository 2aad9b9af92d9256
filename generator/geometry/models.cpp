#include "geometry/models.h"

#include <array>

namespace collage {

std::span<const StarterModel> starter_models() {
  static constexpr std::array models = {
      StarterModel{"sphere", "a sphere of radius 1 with 1,280 triangles",
                   [] { return make_sphere(3); }},
      StarterModel{"teacup", "a teacup with handle and about 300 triangles",
                   [] { return make_teacup(14); }},
      StarterModel{"teapot", "Newell's teapot with about 6,500 triangles",
                   [] { return make_teapot(10); }},
  };
  return models;
}

}  // namespace collage
