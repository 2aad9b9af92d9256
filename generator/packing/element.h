#pragma once

#include <optional>

#include "geometry/bounding_sphere.h"
#include "geometry/distance_bounds.h"
#include "geometry/solid.h"
#include "packing/options.h"

namespace collage {

/// A mesh made ready to be placed. Its unit frame has the smallest enclosing sphere as unit ball.
class Element {
 public:
  /// `distance` says what distances to the element will be measured to; bounds on them are there
  /// for packing by spheres alone, as they cost 90,000 queries, or 25,000 for coarse ones, which
  /// serve as well where an element is one of many, and placed seldom.
  explicit Element(const Mesh& mesh, Distance distance = Distance::exact, Fit fit = Fit::sphere,
                   DistanceBounds::Detail bounds = DistanceBounds::Detail::fine);

  /// The element's size: radius of the smallest enclosing sphere, in the mesh's units.
  [[nodiscard]] double size() const { return solid_.radius(); }
  [[nodiscard]] const dvec3& center() const { return solid_.center(); }
  [[nodiscard]] const Solid& solid() const { return solid_; }
  /// Unit vector from the centre to the farthest vertex.
  [[nodiscard]] const dvec3& farthest_direction() const { return farthest_direction_; }
  [[nodiscard]] std::size_t faces() const { return faces_; }

  /// Answers with distances in the unit frame.
  [[nodiscard]] const ClosestPointIndex& distance_index() const {
    return vertices_ ? *vertices_ : solid_.surface();
  }
  /// Bounds on them, of an element for packing by spheres.
  [[nodiscard]] const DistanceBounds& distance_bounds() const { return *distance_bounds_; }

 private:
  Element(const Mesh& mesh, const Sphere& sphere, Distance distance, Fit fit,
          DistanceBounds::Detail bounds);

  Solid solid_;
  /// Only where distances are approximated by those to the vertices.
  std::optional<ClosestPointIndex> vertices_;
  std::optional<DistanceBounds> distance_bounds_;
  dvec3 farthest_direction_;
  std::size_t faces_;
};

}  // namespace collage
