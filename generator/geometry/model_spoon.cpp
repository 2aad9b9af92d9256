#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

#include "geometry/mesh_parts.h"
#include "geometry/model_materials.h"
#include "geometry/models.h"
#include "geometry/sweep.h"

namespace collage {
namespace {

/// A section across the spoon, in centimetres.
struct Section {
  double x;
  double height;  // of the edges' upper side
  double half_width;
  double hollow;  // depth of the middle under the edges
  double thickness;
};

/// From the handle's end to the tip.
constexpr std::array<Section, 14> sections = {{{-9.0, 1.62, 0.30, 0.0, 0.16},
                                               {-8.8, 1.62, 0.62, 0.0, 0.18},
                                               {-8.0, 1.66, 0.74, 0.0, 0.18},
                                               {-6.0, 1.72, 0.56, 0.0, 0.18},
                                               {-3.0, 1.62, 0.36, 0.0, 0.20},
                                               {0.0, 1.32, 0.30, 0.0, 0.26},
                                               {1.2, 1.12, 0.34, 0.02, 0.28},
                                               {1.9, 1.02, 0.95, 0.30, 0.16},
                                               {2.7, 0.98, 1.60, 0.68, 0.14},
                                               {3.8, 0.95, 1.95, 0.81, 0.14},
                                               {5.0, 0.93, 1.90, 0.77, 0.14},
                                               {6.1, 0.92, 1.50, 0.55, 0.14},
                                               {6.8, 0.92, 0.90, 0.24, 0.14},
                                               {7.1, 0.92, 0.35, 0.04, 0.12}}};

/// Along the upper side from -z to +z, and back along the lower one.
Ring ring_of(const Section& s) {
  constexpr int steps = 8;
  Ring ring;
  for (const double side : {1.0, -1.0}) {
    for (int i = 0; i <= steps; ++i) {
      const double across = side * (2.0 * i / steps - 1.0);
      const double sunk = s.hollow * (1.0 - across * across);
      const double thick = s.thickness * (0.35 + 0.65 * (1.0 - std::pow(across, 4.0)));
      const double y = s.height - sunk - (side > 0.0 ? 0.0 : thick);
      ring.emplace_back(s.x, y, s.half_width * across);
    }
  }
  return ring;
}

}  // namespace

Mesh make_spoon() {
  std::vector<Ring> rings;
  std::transform(sections.begin(), sections.end(), std::back_inserter(rings), ring_of);
  Mesh metal;
  append_rings(metal, rings);
  return make_model(metal, steel(), 50.0);
}

}  // namespace collage
