#pragma once

#include <array>
#include <vector>

#include "preview/framing.h"

namespace collage {

/// The light of templates/studio.inc as numbers. Colours are linear-light RGB; a lamp of colour 1
/// straight above a white surface makes it 1. Directions are unit vectors towards the light.
struct Lamp {
  dvec3 direction{0.0};
  dvec3 color{0.0};
};

/// The same light in as many parts as a pixel has samples; each part is spread over all lamps and
/// has all of their light, and their mean is finer than any.
inline constexpr int samples_a_pixel = 4;
using LampParts = std::array<std::vector<Lamp>, samples_a_pixel>;
LampParts studio_lamps(const Bearing& bearing);

/// From where the key light comes, and how many degrees wide it is for the floor's shadow.
dvec3 key_direction(const Bearing& bearing);
inline constexpr double key_width_degrees = 40.0;
/// How much of the light on the floor is the key's; the rest falls from the whole sky.
inline constexpr double key_share = 0.4;

/// What a mirror shows in a direction of the studio, 1 for white.
double studio_room(const dvec3& direction, const Bearing& bearing);

/// Floor and sky without the sculpture, in the picture's own coordinates, each from -1 to 1.
dvec3 studio_backdrop(double across, double upward);

/// The floor's colour where a share of the light, 0 to 1, does not arrive.
dvec3 shaded_floor(const dvec3& backdrop, double stopped);

}  // namespace collage
