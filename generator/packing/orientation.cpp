#include "packing/orientation.h"

#include <cmath>

namespace collage {

glm::dquat rotation_between(const glm::dvec3& from, const glm::dvec3& to) {
  const double cosine = glm::dot(from, to);
  if (cosine < -1.0 + 1e-12) {  // opposite: half a turn about any axis at right angles
    const glm::dvec3 other = std::abs(from.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 axis = glm::normalize(glm::cross(from, other));
    return {0.0, axis.x, axis.y, axis.z};
  }
  // (1 + cos, from × to) is twice the half-angle's (cos, sin axis), times cos of the half-angle.
  const glm::dvec3 sine_axis = glm::cross(from, to);
  return glm::normalize(glm::dquat(1.0 + cosine, sine_axis.x, sine_axis.y, sine_axis.z));
}

glm::dquat orientation(const glm::dvec3& farthest_direction, const glm::dvec3& towards_surface,
                       double spin_radians) {
  const double half = 0.5 * spin_radians;
  const glm::dvec3 axis = std::sin(half) * towards_surface;
  const glm::dquat spin(std::cos(half), axis.x, axis.y, axis.z);
  return glm::normalize(spin * rotation_between(farthest_direction, towards_surface));
}

}  // namespace collage
