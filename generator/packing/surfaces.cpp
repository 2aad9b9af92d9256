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

float PlacedElement::distance(const dvec3& unit, double limit, double near_enough) const {
  const double error = ClosestPointIndex::error(unit);
  const auto closest = element_->distance_index().find(
      unit, limit / radius_ + error, element_->distance_bounds().hint(unit), near_enough / radius_);
  return closest ? rounded_down(std::max(0.0, closest->distance - error) * radius_)
                 : std::numeric_limits<float>::infinity();
}

Surfaces::Surfaces(const Target& target, std::vector<const Element*> elements)
    : target_(target),
      elements_(std::move(elements)),
      middle_(target.box().center()),
      rounding_(1e-6 * target.box().longest_side()) {}

void Surfaces::resize(std::size_t count) {
  instances_.resize(count);
  spheres_.resize(count);
}

void Surfaces::set(std::size_t index, const Instance& instance) {
  instances_[index] = instance;
  const Element& element = *elements_[instance.element];
  const dvec3 center = instance.world_from_element(element.center());
  spheres_[index] = glm::dvec4(center - middle_, instance.scale * element.size() + rounding_);
}

void Surfaces::add(const Instance& instance) {
  resize(instances_.size() + 1);
  set(instances_.size() - 1, instance);
}

/// False only where no point of the bounding sphere is that near.
bool Surfaces::sphere_is_within(SurfaceId id, const dvec3& point, float limit) const {
  const glm::vec4& sphere = spheres_[id - 1];
  const glm::vec3 away = glm::vec3(point - middle_) - glm::vec3(sphere);
  const float reach = sphere.w + limit;
  return glm::dot(away, away) <= reach * reach * (1.0F + 1e-5F);
}

float Surfaces::least_clearance(SurfaceId id, const dvec3& point, float limit) const {
  if (!sphere_is_within(id, point, limit)) {
    return std::numeric_limits<float>::infinity();
  }
  const PlacedElement instance = placed(id);
  return instance.least_distance(instance.unit_from_world(point));
}

void Surfaces::consider(SurfaceId id, const dvec3& point, Nearest& nearest,
                        double near_enough) const {
  float clearance = 0.0F;
  if (id == target_surface) {
    clearance = rounded_down(target_.clearance_below(point, beyond(nearest.clearance)));
  } else {
    if (!sphere_is_within(id, point, nearest.clearance)) {
      return;
    }
    const PlacedElement instance = placed(id);
    const dvec3 unit = instance.unit_from_world(point);
    if (instance.least_distance(unit) > nearest.clearance) {
      return;
    }
    clearance = instance.distance(unit, beyond(nearest.clearance), near_enough);
  }
  if (clearance < nearest.clearance || (clearance == nearest.clearance && id < nearest.id)) {
    nearest = {id, clearance};
  }
}

dvec3 Surfaces::direction(SurfaceId id, const dvec3& point, double clearance) const {
  if (id == target_surface) {
    return target_.direction_to_surface(point);
  }
  const Instance& neighbour = instances_[id - 1];
  const Element& element = *elements_[neighbour.element];
  const dvec3 unit = element.solid().unit_from_mesh(neighbour.element_from_world(point));
  const double limit = beyond(clearance) / (neighbour.scale * element.size());
  const auto closest = element.solid().surface().find(
      unit, limit + 2.0 * ClosestPointIndex::error(unit), element.distance_bounds().hint(unit));
  return glm::normalize(neighbour.rotation * (closest->point - unit));
}

}  // namespace collage
