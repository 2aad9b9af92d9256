#include "packing/surfaces.h"

#include <algorithm>
#include <limits>

#include "packing/rounding.h"

namespace collage {
namespace {

/// The element's coarse grid serves instances of at most this many voxels across their radius.
constexpr double coarse_radius_voxels = 3.0;

/// A limit that a distance known to be at most `upper` is below, however it is rounded.
double beyond(double upper) { return upper * (1.0 + 1e-5) + std::numeric_limits<double>::min(); }

}  // namespace

PlacedElement::PlacedElement(const Element& element, const Instance& instance, double voxel_side)
    : element_(&element),
      center_(instance.world_from_element(element.center())),
      radius_(instance.scale * element.size()),
      detail_(radius_ < coarse_radius_voxels * voxel_side ? DistanceBounds::Detail::coarse
                                                          : DistanceBounds::Detail::fine),
      unit_from_world_(glm::transpose(glm::mat3_cast(instance.rotation)) * (1.0 / radius_)) {}

float PlacedElement::distance(const dvec3& unit, double limit) const {
  const double error = ClosestPointIndex::error(unit);
  const auto closest = element_->distance_index().find(unit, limit / radius_ + error,
                                                       element_->distance_bounds().hint(unit));
  return closest ? rounded_down(std::max(0.0, closest->distance - error) * radius_)
                 : std::numeric_limits<float>::infinity();
}

void Surfaces::consider(SurfaceId id, const dvec3& point, Nearest& nearest) const {
  float clearance = 0.0F;
  if (id == target_surface) {
    clearance = rounded_down(target_.clearance_below(point, beyond(nearest.clearance)));
  } else {
    const Instance& instance = instances[id - 1];
    const Element& element = *elements_[instance.element];
    const dvec3 away = point - instance.world_from_element(element.center());
    const double reach = instance.scale * element.size() + nearest.clearance;
    if (glm::dot(away, away) > reach * reach * (1.0 + 4e-5)) {
      return;
    }
    const PlacedElement neighbour = placed(id);
    const dvec3 unit = neighbour.unit_from_world(point);
    const double limit = beyond(nearest.clearance);
    if (!neighbour.may_be_within(unit, static_cast<float>(limit))) {
      return;
    }
    clearance = neighbour.distance(unit, limit);
  }
  if (clearance < nearest.clearance || (clearance == nearest.clearance && id < nearest.id)) {
    nearest = {id, clearance};
  }
}

dvec3 Surfaces::direction(SurfaceId id, const dvec3& point, double clearance) const {
  if (id == target_surface) {
    return target_.direction_to_surface(point);
  }
  const Instance& neighbour = instances[id - 1];
  const Element& element = *elements_[neighbour.element];
  const dvec3 unit = element.solid().unit_from_mesh(neighbour.element_from_world(point));
  const double limit = beyond(clearance) / (neighbour.scale * element.size());
  const auto closest = element.solid().surface().find(
      unit, limit + 2.0 * ClosestPointIndex::error(unit), element.distance_bounds().hint(unit));
  return glm::normalize(neighbour.rotation * (closest->point - unit));
}

}  // namespace collage
