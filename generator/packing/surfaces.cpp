#include "packing/surfaces.h"

#include <algorithm>
#include <limits>

#include "packing/rounding.h"

namespace collage {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// A limit that a distance known to be at most `upper` is below, however it is rounded.
double beyond(double upper) { return upper * (1.0 + 1e-5) + std::numeric_limits<double>::min(); }

}  // namespace

PlacedElement::PlacedElement(const Element& element, const Instance& instance)
    : element_(&element),
      center_(instance.world_from_element(element.center())),
      radius_(instance.scale * element.size()),
      unit_from_world_(glm::transpose(glm::mat3_cast(instance.rotation)) * (1.0 / radius_)) {}

float PlacedElement::distance(const dvec3& unit, double limit) const {
  const double error = ClosestPointIndex::error(unit);
  const auto closest = element_->distance_index().find(unit, limit / radius_ + error,
                                                       element_->distance_bounds().hint(unit));
  return closest ? rounded_down(std::max(0.0, closest->distance - error) * radius_)
                 : std::numeric_limits<float>::infinity();
}

float Surfaces::clearance(SurfaceId id, const dvec3& point, double upper) const {
  if (id == target_surface) {
    return rounded_down(target_.clearance(point));
  }
  const PlacedElement neighbour = placed(instances[id - 1]);
  return neighbour.distance(neighbour.unit_from_world(point), beyond(upper));
}

std::pair<SurfaceId, float> Surfaces::nearest(const dvec3& point) const {
  SurfaceId nearest = target_surface;
  float clearance = rounded_down(target_.clearance(point));
  for (std::size_t i = 0; i < instances.size(); ++i) {
    const Instance& instance = instances[i];
    const Element& element = *elements_[instance.element];
    const dvec3 center = instance.world_from_element(element.center());
    if (glm::distance(point, center) - instance.scale * element.size() >= clearance) {
      continue;
    }
    const PlacedElement neighbour(element, instance);
    const float distance = neighbour.distance(neighbour.unit_from_world(point), clearance);
    if (distance < clearance) {
      nearest = static_cast<SurfaceId>(i + 1);
      clearance = distance;
    }
  }
  return {nearest, clearance};
}

dvec3 Surfaces::direction(SurfaceId id, const dvec3& point) const {
  if (id == target_surface) {
    return target_.direction_to_surface(point);
  }
  const Instance& neighbour = instances[id - 1];
  const Solid& solid = elements_[neighbour.element]->solid();
  const dvec3 unit = solid.unit_from_mesh(neighbour.element_from_world(point));
  const auto closest = solid.surface().find(unit, unbounded);
  return glm::normalize(neighbour.rotation * (closest->point - unit));
}

}  // namespace collage
