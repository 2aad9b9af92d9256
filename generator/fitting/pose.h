#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "geometry/instance.h"
#include "packing/element.h"

namespace collage {

/// Where an element's unit frame stands in the world.
struct Pose {
  glm::dvec3 center{0.0};
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
  /// Radius of the enclosing sphere, in world units; 0: nowhere.
  double radius = 0.0;

  [[nodiscard]] Instance instance(std::uint32_t index, const Element& element) const {
    return instance(index, element, radius / element.size());
  }
  /// With exactly this scale.
  [[nodiscard]] Instance instance(std::uint32_t index, const Element& element, double scale) const {
    return {index, scale, rotation, center - rotation * (scale * element.center())};
  }
};

}  // namespace collage
