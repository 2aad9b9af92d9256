#pragma once

#include <glm/glm.hpp>

namespace collage {

/// Linear light, 0 to 1, of a colour as screens are sent it, and back (IEC 61966-2-1).
glm::dvec3 linear_from_srgb(const glm::dvec3& encoded);
glm::dvec3 srgb_from_linear(const glm::dvec3& linear);

}  // namespace collage
