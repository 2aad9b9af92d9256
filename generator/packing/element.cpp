#include "packing/element.h"

namespace collage {

Element::Element(const Mesh& mesh, Distance distance)
    : Element(mesh, smallest_enclosing_sphere(mesh.positions), distance) {}

Element::Element(const Mesh& mesh, const Sphere& sphere, Distance distance)
    : solid_(mesh, sphere.center, sphere.radius),
      farthest_direction_(farthest_point(mesh.positions, sphere.center).direction),
      faces_(mesh.triangles.size()) {
  if (distance == Distance::vertices) {
    vertices_.emplace(in_unit_frame(mesh, sphere.center, sphere.radius),
                      ClosestPointIndex::Surface::vertices);
  }
}

}  // namespace collage
