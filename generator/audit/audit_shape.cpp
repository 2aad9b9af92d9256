#include "audit/audit_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "geometry/boxes.h"

namespace collage {
namespace {

/// Sets of vertices, by union-find with halving of paths.
class Sets {
 public:
  explicit Sets(std::size_t size) : parent_(size) {
    for (std::size_t i = 0; i < size; ++i) {
      parent_[i] = static_cast<std::uint32_t>(i);
    }
  }
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) {
      i = parent_[i] = parent_[parent_[i]];
    }
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) { parent_[root(a)] = root(b); }

 private:
  std::vector<std::uint32_t> parent_;
};

struct LessPosition {
  bool operator()(const dvec3& a, const dvec3& b) const {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  }
};

std::vector<dvec3> points_of_parts(const Mesh& mesh) {
  Sets sets(mesh.positions.size());
  std::map<dvec3, std::uint32_t, LessPosition> first_at;
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    sets.join(v, first_at.emplace(mesh.positions[v], v).first->second);
  }
  for (const uvec3& t : mesh.triangles) {
    sets.join(t.x, t.y);
    sets.join(t.y, t.z);
  }
  std::vector<dvec3> points;
  std::vector<char> seen(mesh.positions.size(), 0);
  for (const uvec3& t : mesh.triangles) {
    char& part_seen = seen[sets.root(t.x)];
    if (part_seen == 0) {
      points.push_back(mesh.positions[t.x]);
      part_seen = 1;
    }
  }
  return points;
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

}  // namespace

AuditShape::AuditShape(const Mesh& mesh)
    : mesh_(mesh),
      tree_(boxes_of_triangles(mesh)),
      winding_number_(mesh),
      part_points_(points_of_parts(mesh)) {}

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

bool has_part_inside(const AuditShape& a, const Instance& instance_a, const AuditShape& b,
                     const Instance& instance_b) {
  return std::any_of(b.part_points().begin(), b.part_points().end(), [&](const dvec3& part_point) {
    const dvec3 point = instance_a.element_from_world(instance_b.world_from_element(part_point));
    const Box& box = a.box();
    const bool in_box = glm::all(glm::greaterThanEqual(point, box.min)) &&
                        glm::all(glm::lessThanEqual(point, box.max));
    return in_box && a.holds(point);
  });
}

}  // namespace collage
