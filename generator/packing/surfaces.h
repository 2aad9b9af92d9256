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
  /// `limit`. `unit` is outside. The result is the same for every limit that it is below; where it
  /// is below `near_enough` it may come out larger, but still below that.
  [[nodiscard]] float distance(const dvec3& unit, double limit, double near_enough = 0.0) const;
  /// No more than distance().
  [[nodiscard]] float least_distance(const dvec3& unit) const {
    const glm::vec3 query(unit);
    const float error = float_error * (1.0F + glm::length(query));
    const float least = std::sqrt(std::max(squared_bounds(query).lower, 0.0F)) * below_one - error;
    return std::max(least, 0.0F) * (static_cast<float>(radius_) * below_one);
  }
  /// Around distance(), in world units, for four points, which may be off by `off` in the unit
  /// frame and 3·10⁻⁷ of their lengths.
  struct Bounds {
    Four lower;
    Four upper;
  };
  [[nodiscard]] Bounds bounds(const Points<Four>& units, float off) const {
    const auto [lower, gap] = squared_bounds(units);
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

  [[nodiscard]] DistanceBounds::Squared<float> squared_bounds(const glm::vec3& query) const {
    const float squared_length = glm::dot(query, query);
    if (squared_length < DistanceBounds::reach * DistanceBounds::reach) {
      return element_->distance_bounds().squared(query, detail_);
    }
    const float length = std::sqrt(squared_length);  // the unit ball: between length - 1 and + 1
    return {(length - 1.0F) * (length - 1.0F), 4.0F * length};
  }
  [[nodiscard]] DistanceBounds::Squared<Four> squared_bounds(const Points<Four>& queries) const {
    const Four squared_length = dot(queries, queries);
    const FourIntegers is_near = squared_length < DistanceBounds::reach * DistanceBounds::reach;
    if ((is_near[0] & is_near[1] & is_near[2] & is_near[3]) != 0) {
      return element_->distance_bounds().squared(queries, detail_);
    }
    const Four length = square_root(squared_length);
    const Four least = larger(length - 1.0F, Four{});
    return {least * least, 4.0F * larger(length, all_four(1.0F))};
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
  Surfaces(const Target& target, std::vector<const Element*> elements);

  [[nodiscard]] const std::vector<Instance>& instances() const { return instances_; }
  [[nodiscard]] std::vector<Instance> take_instances() { return std::move(instances_); }
  /// Ends with those of a smaller number, or with such as have yet to be set.
  void resize(std::size_t count);
  /// Different ones may be set at the same time.
  void set(std::size_t index, const Instance& instance);
  void add(const Instance& instance);

  /// Instance `id`; see PlacedElement.
  [[nodiscard]] PlacedElement placed(SurfaceId id, double voxel_side = 0.0) const {
    const Instance& instance = instances_[id - 1];
    return {*elements_[instance.element], instance, voxel_side};
  }
  /// Makes a surface the nearest to a point, which is in no instance, where it is nearer than the
  /// one so far, or as near and comes before it. A clearance below `near_enough` may come out
  /// larger, but still below that.
  void consider(SurfaceId id, const dvec3& point, Nearest& nearest, double near_enough = 0.0) const;
  /// No more than the clearance that an instance leaves; infinite where its bounding sphere is not
  /// within `limit`. About a tenth of the cost of consider().
  [[nodiscard]] float least_clearance(SurfaceId id, const dvec3& point, float limit) const;
  /// Unit vector to the nearest point of the surface, whose distance() is `clearance`.
  [[nodiscard]] dvec3 direction(SurfaceId id, const dvec3& point, double clearance) const;

 private:
  [[nodiscard]] bool sphere_is_within(SurfaceId id, const dvec3& point, float limit) const;

  const Target& target_;
  std::vector<const Element*> elements_;
  std::vector<Instance> instances_;
  /// Of each instance, from `middle_`: centre and radius, which is larger by what float loses.
  std::vector<glm::vec4> spheres_;
  dvec3 middle_;
  double rounding_;
};

}  // namespace collage
