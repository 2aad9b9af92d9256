#pragma once

#include <vector>

#include "fitting/collision_shape.h"
#include "fitting/distance_field.h"
#include "geometry/covering_spheres.h"
#include "geometry/linking_number.h"
#include "packing/element.h"

namespace collage {

/// A cover as the optimiser reads it: many small float numbers.
struct SphereSet {
  /// `trusted` is the share of the bulge, or of the depth where that is less, that is given away.
  SphereSet(const SphereCover& cover, double trusted);

  std::vector<glm::vec3> centers;
  /// Less than those of the cover by what is given away: where such spheres fit the solid may or
  /// may not, and the exact test decides.
  std::vector<float> radii;
  /// All of their numbers, each near the one before it: who goes this way finds most of what he
  /// looks up in a lattice in the cache.
  std::vector<std::uint32_t> order;
};

/// What of an element's shape takes long to find out, all in its unit frame.
struct ShapeData {
  SphereCover coarse;
  SphereCover fine;
  /// Signed distances, positive outside.
  DistanceField distances;
};

/// Numbers of spheres in the two covers.
inline constexpr std::size_t coarse_spheres = 32;
inline constexpr std::size_t fine_spheres = 500;

/// Cost: a few seconds.
ShapeData measure_shape(const Mesh& mesh, const Element& element);

/// Normal of a loop, twice as long as its area.
dvec3 area_vector(const Loop& loop);

/// An element made ready to be fitted by its shape. Refers to the mesh and the element.
class ShapedElement {
 public:
  ShapedElement(const Mesh& mesh, const Element& element, ShapeData data);

  [[nodiscard]] const Element& element() const { return *element_; }
  [[nodiscard]] const CollisionShape& collision() const { return collision_; }
  [[nodiscard]] const SphereSet& coarse() const { return coarse_; }
  [[nodiscard]] const SphereSet& fine() const { return fine_; }
  /// The finer cover with nothing given away: where it fits the solid does.
  [[nodiscard]] const SphereSet& cautious() const { return cautious_; }
  /// The finer cover, with all of its bulge.
  [[nodiscard]] const SphereCover& cover() const { return data_.fine; }
  [[nodiscard]] const DistanceField& distances() const { return data_.distances; }
  [[nodiscard]] const DistanceMinima& distance_minima() const { return minima_; }
  /// Of the unit frame's solid.
  [[nodiscard]] double unit_volume() const { return unit_volume_; }
  /// The deepest point inside, and its depth.
  [[nodiscard]] const Sphere& inscribed() const { return inscribed_; }
  /// See handle_loops(); none for elements of more than four handles.
  [[nodiscard]] const std::vector<Loop>& loops() const { return loops_; }
  /// The loop that goes round the largest opening; nullptr where there is none.
  [[nodiscard]] const Loop* ring() const { return loops_.empty() ? nullptr : &loops_[ring_]; }
  /// Unit vector along which the element is longest.
  [[nodiscard]] const dvec3& long_axis() const { return long_axis_; }

 private:
  const Element* element_;
  CollisionShape collision_;
  ShapeData data_;
  DistanceMinima minima_;
  SphereSet coarse_;
  SphereSet fine_;
  SphereSet cautious_;
  double unit_volume_;
  Sphere inscribed_;
  dvec3 long_axis_;
  std::vector<Loop> loops_;
  std::size_t ring_ = 0;
};

}  // namespace collage
