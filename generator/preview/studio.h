#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "preview/floor_shadow.h"
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

/// The light that makes the floor's shadow in a template that comes along, "studio" without its
/// ending; nullopt for others.
std::optional<FloorLight> floor_light(std::string_view look);

/// What stands on the floor there: templates that show the target have it stand there too.
Standing standing(std::string_view look);

/// What a mirror shows in a direction of the studio, 1 for white.
double studio_room(const dvec3& direction, const Bearing& bearing);

/// Floor and sky without the sculpture, in the picture's own coordinates, each from -1 to 1.
dvec3 studio_backdrop(double across, double upward);

/// The floor's colour where a share of the light, 0 to 1, does not arrive.
dvec3 shaded_floor(const dvec3& backdrop, double stopped);

}  // namespace collage
