#include "packing/element.h"

namespace collage {
namespace {

std::optional<ClosestPointIndex> vertex_index(const Mesh& mesh, const Sphere& sphere,
                                              Distance distance) {
  if (distance != Distance::vertices) {
    return std::nullopt;
  }
  return std::optional<ClosestPointIndex>(std::in_place,
                                          in_unit_frame(mesh, sphere.center, sphere.radius),
                                          ClosestPointIndex::Surface::vertices);
}

}  // namespace

Element::Element(const Mesh& mesh, Distance distance, Fit fit, DistanceBounds::Detail bounds)
    : Element(mesh, smallest_enclosing_sphere(mesh.positions), distance, fit, bounds) {}

Element::Element(const Mesh& mesh, const Sphere& sphere, Distance distance, Fit fit,
                 DistanceBounds::Detail bounds)
    : solid_(mesh, sphere.center, sphere.radius),
      vertices_(vertex_index(mesh, sphere, distance)),
      farthest_direction_(farthest_point(mesh.positions, sphere.center).direction),
      faces_(mesh.triangles.size()) {
  if (fit == Fit::sphere) {
    distance_bounds_.emplace(distance_index(), bounds);
  }
}

}  // namespace collage
