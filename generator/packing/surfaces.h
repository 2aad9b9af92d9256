#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "geometry/four.h"
#include "geometry/instance.h"
#include "packing/element.h"
#include "packing/nearest_surface.h"
#include "packing/target.h"

namespace collage {

/// An instance seen from points in the world.
class PlacedElement {
 public:
  /// Bounds are coarser where the instance covers few voxels of this side.
  PlacedElement(const Element& element, const Instance& instance, double voxel_side = 0.0);

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
  /// False only where distance() is not below `limit`.
  [[nodiscard]] bool may_be_within(const dvec3& unit, float limit) const {
    const glm::vec3 query(unit);
    const float error = float_error * (1.0F + glm::length(query));
    const float unit_limit = limit / static_cast<float>(radius_) * above_one + error;
    return squared_bounds(query).lower < unit_limit * unit_limit * above_one;
  }
  /// Around distance(), in world units, for four points, which may be off by `off` in the unit
  /// frame and 3·10⁻⁷ of their lengths.
  struct Bounds {
    Four lower;
    Four upper;
  };
  [[nodiscard]] Bounds bounds(const Points<Four>& units, float off) const {
    const auto at = [&](std::size_t lane) {
      return squared_bounds({units[0][lane], units[1][lane], units[2][lane]});
    };
    const std::array squared{at(0), at(1), at(2), at(3)};
    const Four lower{squared[0].lower, squared[1].lower, squared[2].lower, squared[3].lower};
    const Four gap{squared[0].gap, squared[1].gap, squared[2].gap, squared[3].gap};
    const Four error = off + float_error * (1.0F + square_root(dot(units, units)));
    const Four least = square_root(larger(lower, Four{})) * below_one - error;
    const Four most = square_root(larger(lower + gap, Four{})) + error;
    const auto radius = static_cast<float>(radius_);
    return {larger(least, Four{}) * (radius * below_one), most * (radius * above_one)};
  }
  [[nodiscard]] const Element& element() const { return *element_; }
  [[nodiscard]] const glm::dmat3& unit_from_world() const { return unit_from_world_; }

  /// Outweigh the rounding of a few operations.
  static constexpr float below_one = 1.0F - 0x1p-21F;
  static constexpr float above_one = 1.0F + 0x1p-21F;

 private:
  /// What is taken off a distance that was found exactly, and that rounding to float loses.
  static constexpr float float_error = 2.5e-6F;

  [[nodiscard]] DistanceBounds::Squared squared_bounds(const glm::vec3& query) const {
    const float farthest = std::max({std::abs(query.x), std::abs(query.y), std::abs(query.z)});
    if (farthest < DistanceBounds::reach) {
      return element_->distance_bounds().squared(query, detail_);
    }
    const float length = glm::length(query);  // within the unit ball: between length - 1 and + 1
    return {(length - 1.0F) * (length - 1.0F), 4.0F * length};
  }

  const Element* element_;
  dvec3 center_;
  double radius_;
  DistanceBounds::Detail detail_;
  glm::dmat3 unit_from_world_;
};

/// The nearest of some surfaces, and the clearance that it leaves.
struct Nearest {
  SurfaceId id = several_surfaces;
  float clearance = std::numeric_limits<float>::infinity();
};

/// The target and the instances placed so far.
class Surfaces {
 public:
  /// The elements are those that instances index; they and the target must outlive this.
  Surfaces(const Target& target, std::vector<const Element*> elements)
      : target_(target), elements_(std::move(elements)) {}

  std::vector<Instance> instances;

  /// Instance `id`; see PlacedElement.
  [[nodiscard]] PlacedElement placed(SurfaceId id, double voxel_side = 0.0) const {
    const Instance& instance = instances[id - 1];
    return {*elements_[instance.element], instance, voxel_side};
  }
  /// Makes a surface the nearest to a point, which is in no instance, where it is nearer than the
  /// one so far, or as near and comes before it.
  void consider(SurfaceId id, const dvec3& point, Nearest& nearest) const;
  /// Unit vector to the nearest point of the surface, whose distance() is `clearance`.
  [[nodiscard]] dvec3 direction(SurfaceId id, const dvec3& point, double clearance) const;

 private:
  const Target& target_;
  std::vector<const Element*> elements_;
};

}  // namespace collage
