#include "geometry/color.h"

#include <cmath>

namespace collage {

glm::dvec3 linear_from_srgb(const glm::dvec3& encoded) {
  glm::dvec3 linear;
  for (int channel = 0; channel < 3; ++channel) {
    const double e = encoded[channel];
    linear[channel] = e <= 0.04045 ? e / 12.92 : std::pow((e + 0.055) / 1.055, 2.4);
  }
  return linear;
}

glm::dvec3 srgb_from_linear(const glm::dvec3& linear) {
  glm::dvec3 encoded;
  for (int channel = 0; channel < 3; ++channel) {
    const double l = linear[channel];
    encoded[channel] = l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1.0 / 2.4) - 0.055;
  }
  return encoded;
}

}  // namespace collage
