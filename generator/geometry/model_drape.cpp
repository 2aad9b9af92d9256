#include <cmath>

#include <glm/gtc/constants.hpp>

#include "geometry/mesh_parts.h"
#include "geometry/model_materials.h"
#include "geometry/models.h"
#include "geometry/sweep.h"

namespace collage {
namespace {

constexpr double thickness = 0.09;

/// The middle of the cloth, `way` from its centre and `around` it in radians: over the upper half
/// of the unit ball, then straight down, with folds that deepen on the way.
dvec3 cloth(double way, double around) {
  constexpr double deepest = 0.2;
  const double over = glm::min(way, glm::half_pi<double>());
  const double uneven = 1.0 + 0.35 * std::cos(3.0 * around + 1.0);
  const double fold = deepest * uneven * glm::smoothstep(0.9, 2.4, way);
  const double radius = std::sin(over) + fold * std::cos(9.0 * around);
  return {radius * std::cos(around), std::cos(over) - (way - over), radius * std::sin(around)};
}

dvec3 normal(double way, double around) {
  constexpr double step = 1e-4;
  const dvec3 down = cloth(way + step, around) - cloth(way - step, around);
  const dvec3 along = cloth(way, around + step) - cloth(way, around - step);
  return glm::normalize(glm::cross(along, down));
}

}  // namespace

Mesh make_drape() {
  constexpr int segments = 108;
  constexpr int rows = 22;
  constexpr double length = 2.45;
  std::vector<Ring> rings;
  const auto append_ring = [&](int row, double height) {
    const double way = glm::max(1e-3, length * row / rows);
    Ring ring;
    for (int i = 0; i < segments; ++i) {
      const double around = glm::two_pi<double>() * i / segments;
      const dvec3 off = row == 0 ? dvec3(0.0, 1.0, 0.0) : normal(way, around);
      const dvec3 middle = row == 0 ? dvec3(0.0, 1.0, 0.0) : cloth(way, around);
      ring.push_back(middle + height * off + dvec3(0.0, length - glm::half_pi<double>(), 0.0));
    }
    rings.push_back(ring);
  };
  for (int row = 0; row <= rows; ++row) {
    append_ring(row, 0.5 * thickness);
  }
  for (int row = rows; row >= 0; --row) {
    append_ring(row, -0.5 * thickness);
  }
  Mesh sheet;
  append_rings(sheet, rings);
  return make_model(sheet, steel(), 60.0);
}

}  // namespace collage
