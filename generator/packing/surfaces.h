#pragma once

#include <utility>
#include <vector>

#include "geometry/instance.h"
#include "packing/element.h"
#include "packing/nearest_surface.h"
#include "packing/target.h"

namespace collage {

/// An instance seen from points in the world.
class PlacedElement {
 public:
  PlacedElement(const Element& element, const Instance& instance);

  /// Centre and radius of the bounding sphere.
  [[nodiscard]] const dvec3& center() const { return center_; }
  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] dvec3 unit_from_world(const dvec3& point) const {
    return unit_from_world_ * (point - center_);
  }
  [[nodiscard]] bool holds(const dvec3& unit) const {
    return glm::dot(unit, unit) <= 1.0 && element_->solid().inside(unit);
  }
  /// Exact distance in world units, rounded down to float; infinite where that is not below
  /// `limit`. `unit` is outside. The result is the same for every limit that it is below.
  [[nodiscard]] float distance(const dvec3& unit, double limit) const;
  [[nodiscard]] const Element& element() const { return *element_; }

 private:
  const Element* element_;
  dvec3 center_;
  double radius_;
  glm::dmat3 unit_from_world_;
};

/// The target and the instances placed so far.
class Surfaces {
 public:
  /// The elements are those that instances index; they and the target must outlive this.
  Surfaces(const Target& target, std::vector<const Element*> elements)
      : target_(target), elements_(std::move(elements)) {}

  std::vector<Instance> instances;

  [[nodiscard]] PlacedElement placed(const Instance& instance) const {
    return {*elements_[instance.element], instance};
  }
  /// The clearance at a point that is in no instance, as far as one surface is concerned; known to
  /// be at most `upper`.
  [[nodiscard]] float clearance(SurfaceId id, const dvec3& point, double upper) const;
  /// The nearest surface with the clearance, by a look at every instance: O(n).
  [[nodiscard]] std::pair<SurfaceId, float> nearest(const dvec3& point) const;
  /// Unit vector to the nearest point of the surface.
  [[nodiscard]] dvec3 direction(SurfaceId id, const dvec3& point) const;

 private:
  const Target& target_;
  std::vector<const Element*> elements_;
};

}  // namespace collage
