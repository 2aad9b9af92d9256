#include "fitting/collision_shape.h"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/boxes.h"
#include "geometry/topology.h"
#include "geometry/triangle_distance.h"

namespace collage {
namespace {

/// One vertex of each set of triangles that hang together by vertices at the same place.
std::vector<dvec3> find_part_vertices(const Mesh& mesh) {
  std::vector<dvec3> vertices;
  const std::vector<std::uint32_t> part_of = parts_by_vertices(mesh);
  for (std::size_t t = 0; t < part_of.size(); ++t) {
    if (part_of[t] == vertices.size()) {  // parts are numbered in this order
      vertices.push_back(mesh.corner(t, 0));
    }
  }
  return vertices;
}

/// Boxes of b seen from a, widened by what rounding and the gap may do to them.
class BoxMap {
 public:
  BoxMap(const Instance& a, const Instance& b, double gap, double size_of_a) {
    const glm::dmat3 a_from_world = glm::transpose(glm::mat3_cast(a.rotation)) * (1.0 / a.scale);
    matrix_ = a_from_world * glm::mat3_cast(b.rotation) * b.scale;
    offset_ = a_from_world * (b.translation - a.translation);
    for (int column = 0; column < 3; ++column) {
      absolute_[column] = glm::abs(matrix_[column]);
    }
    const double world = glm::length(a.translation) + glm::length(b.translation);
    slack_ = 1e-12 * (world / a.scale + size_of_a) + gap / a.scale;
  }

  [[nodiscard]] Box operator()(const Box& box) const {
    const dvec3 center = matrix_ * box.center() + offset_;
    const dvec3 half = absolute_ * (0.5 * box.extent()) + slack_;
    return {center - half, center + half};
  }

 private:
  glm::dmat3 matrix_;
  glm::dmat3 absolute_;
  dvec3 offset_;
  double slack_;
};

Corners world_corners(const Mesh& mesh, const Instance& instance, std::uint32_t triangle) {
  return {instance.world_from_element(mesh.corner(triangle, 0)),
          instance.world_from_element(mesh.corner(triangle, 1)),
          instance.world_from_element(mesh.corner(triangle, 2))};
}

}  // namespace

CollisionShape::CollisionShape(const Mesh& mesh, const Solid& solid)
    : mesh_(&mesh),
      solid_(&solid),
      tree_(boxes_of_triangles(mesh)),
      part_vertices_(find_part_vertices(mesh)) {}

bool surfaces_come_within(double gap, const CollisionShape& a, const Instance& instance_a,
                          const CollisionShape& b, const Instance& instance_b) {
  const auto& nodes_a = a.tree().nodes();
  const auto& nodes_b = b.tree().nodes();
  const double size_of_a =
      glm::length(nodes_a.front().box.min) + glm::length(nodes_a.front().box.max);
  const BoxMap in_a(instance_a, instance_b, gap, size_of_a);
  std::array<std::pair<std::uint32_t, std::uint32_t>, 2 * BoxTree::deepest> stack;
  std::size_t depth = 0;
  stack[depth++] = {0, 0};
  while (depth > 0) {
    const auto [ia, ib] = stack[--depth];
    const BoxTree::Node& na = nodes_a[ia];
    const BoxTree::Node& nb = nodes_b[ib];
    const Box box_b = in_a(nb.box);
    if (!boxes_meet(na.box, box_b)) {
      continue;
    }
    if (na.is_leaf() && nb.is_leaf()) {
      const Corners s = world_corners(a.mesh(), instance_a, na.item);
      const Corners t = world_corners(b.mesh(), instance_b, nb.item);
      if (gap > 0.0 ? triangle_distance(s, t) <= gap : triangles_intersect(s, t)) {
        return true;
      }
    } else if (nb.is_leaf() || (!na.is_leaf() && na.box.longest_side() > box_b.longest_side())) {
      stack[depth++] = {ia + 1, ib};
      stack[depth++] = {na.second_child, ib};
    } else {
      stack[depth++] = {ia, ib + 1};
      stack[depth++] = {ia, nb.second_child};
    }
  }
  return false;
}

bool has_part_inside(const CollisionShape& a, const Instance& instance_a, const CollisionShape& b,
                     const Instance& instance_b) {
  return std::ranges::any_of(b.part_vertices(), [&](const dvec3& vertex) {
    const dvec3 unit = a.solid().unit_from_mesh(
        instance_a.element_from_world(instance_b.world_from_element(vertex)));
    return glm::dot(unit, unit) <= 1.0 && a.solid().inside(unit);
  });
}

bool has_part_outside(const CollisionShape& target, const CollisionShape& b,
                      const Instance& instance_b) {
  return std::ranges::any_of(b.part_vertices(), [&](const dvec3& vertex) {
    return !target.solid().inside(
        target.solid().unit_from_mesh(instance_b.world_from_element(vertex)));
  });
}

}  // namespace collage
