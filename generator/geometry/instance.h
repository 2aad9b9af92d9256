#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace collage {

/// One placed copy of an element.
struct Instance {
  /// Index into the scene's elements.
  std::uint32_t element = 0;
  double scale = 1.0;
  /// Unit quaternion.
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
  glm::dvec3 translation{0.0};

  /// p ↦ rotation · (scale p) + translation, for p as in the element's mesh file.
  [[nodiscard]] glm::dvec3 world_from_element(const glm::dvec3& point) const {
    return rotation * (scale * point) + translation;
  }
  [[nodiscard]] glm::dvec3 element_from_world(const glm::dvec3& point) const {
    return glm::conjugate(rotation) * (point - translation) / scale;
  }
};

}  // namespace collage
