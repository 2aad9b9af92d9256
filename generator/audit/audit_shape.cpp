#include "audit/audit_shape.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/boxes.h"
#include "geometry/topology.h"

namespace collage {
namespace {

/// The vertices of each set of triangles that hang together by vertices at the same place.
std::vector<std::vector<dvec3>> parts_of(const Mesh& mesh) {
  const std::vector<std::uint32_t> part_of = parts_by_vertices(mesh);
  std::vector<std::vector<dvec3>> parts;
  std::vector<char> seen(mesh.positions.size(), 0);
  for (std::size_t t = 0; t < part_of.size(); ++t) {
    parts.resize(std::max<std::size_t>(parts.size(), part_of[t] + 1));
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t vertex = mesh.triangles[t][k];
      if (seen[vertex] == 0) {
        seen[vertex] = 1;
        parts[part_of[t]].push_back(mesh.positions[vertex]);
      }
    }
  }
  return parts;
}

/// target_from_source for two instances, as p ↦ matrix p + offset, with what rounding may do to it.
struct Relative {
  glm::dmat3 matrix;
  glm::dmat3 absolute;
  dvec3 offset;
  double slack;

  Relative(const Instance& to, const Instance& from, const Box& to_box) {
    const glm::dmat3 to_inverse = glm::transpose(glm::mat3_cast(to.rotation)) * (1.0 / to.scale);
    matrix = to_inverse * glm::mat3_cast(from.rotation) * from.scale;
    offset = to_inverse * (from.translation - to.translation);
    for (int column = 0; column < 3; ++column) {
      absolute[column] = glm::abs(matrix[column]);
    }
    // World coordinates are rounded to 2⁻⁵³ of their size; the slack is far above that.
    const double world = glm::length(to.translation) + glm::length(from.translation);
    slack = 1e-12 * (world / to.scale + glm::length(to_box.min) + glm::length(to_box.max));
  }

  [[nodiscard]] Box box(const Box& source) const {
    const dvec3 center = matrix * source.center() + offset;
    const dvec3 half = absolute * (0.5 * source.extent()) + slack;
    return {center - half, center + half};
  }
};

Corners world_corners(const Mesh& mesh, const Instance& instance, std::uint32_t triangle) {
  return {instance.world_from_element(mesh.corner(triangle, 0)),
          instance.world_from_element(mesh.corner(triangle, 1)),
          instance.world_from_element(mesh.corner(triangle, 2))};
}

/// Whether `holds` says of some part of b, as seen from a, where it lies: where a is closed and
/// surfaces do not meet, one vertex stands for its part. Where a is open, whether it says so of all
/// vertices of b, as its inside ends in empty space.
template <class Holds>
bool holds_of_a_part(const AuditShape& a, const AuditShape& b, Holds holds) {
  if (a.closed()) {
    return std::ranges::any_of(b.parts(), [&](const auto& part) { return holds(part.front()); });
  }
  return std::ranges::all_of(b.parts(),
                             [&](const auto& part) { return std::ranges::all_of(part, holds); });
}

}  // namespace

AuditShape::AuditShape(const Mesh& mesh)
    : mesh_(mesh),
      tree_(boxes_of_triangles(mesh)),
      winding_number_(mesh),
      parts_(parts_of(mesh)),
      closed_(is_closed(mesh)) {}

bool AuditShape::holds(const dvec3& point) const {
  const double fast = winding_number_.at(point);
  return (std::abs(fast - 0.5) > 0.1 ? fast : winding_number(mesh_, point)) > 0.5;
}

Box world_box(const AuditShape& shape, const Instance& instance) {
  Box box;
  for (const dvec3& position : shape.mesh().positions) {
    box.include(instance.world_from_element(position));
  }
  return box;
}

bool surfaces_meet(const AuditShape& a, const Instance& instance_a, const AuditShape& b,
                   const Instance& instance_b) {
  const Relative a_from_b(instance_a, instance_b, a.box());
  std::array<std::pair<std::uint32_t, std::uint32_t>, 2 * BoxTree::deepest> stack;
  std::size_t depth = 0;
  stack[depth++] = {0, 0};
  while (depth > 0) {
    const auto [ia, ib] = stack[--depth];
    const BoxTree::Node& na = a.tree().nodes()[ia];
    const BoxTree::Node& nb = b.tree().nodes()[ib];
    const Box box_b = a_from_b.box(nb.box);
    if (!boxes_meet(na.box, box_b)) {
      continue;
    }
    if (na.is_leaf() && nb.is_leaf()) {
      if (triangles_intersect(world_corners(a.mesh(), instance_a, na.item),
                              world_corners(b.mesh(), instance_b, nb.item))) {
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

bool lies_inside(const AuditShape& a, const Instance& instance_a, const AuditShape& b,
                 const Instance& instance_b) {
  return holds_of_a_part(a, b, [&](const dvec3& vertex) {
    const dvec3 point = instance_a.element_from_world(instance_b.world_from_element(vertex));
    const Box& box = a.box();
    const bool in_box = glm::all(glm::greaterThanEqual(point, box.min)) &&
                        glm::all(glm::lessThanEqual(point, box.max));
    return in_box && a.holds(point);
  });
}

bool lies_outside(const AuditShape& target, const AuditShape& b, const Instance& instance_b) {
  return holds_of_a_part(target, b, [&](const dvec3& vertex) {
    return !target.holds(instance_b.world_from_element(vertex));
  });
}

}  // namespace collage
