#include "fitting/collision_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
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

/// Points of b seen from a, and boxes, widened by what rounding and the gap may do to them.
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

  /// By how much a point or the gap may be off, in a's units.
  [[nodiscard]] double slack() const { return slack_; }
  [[nodiscard]] dvec3 operator()(const dvec3& point) const { return matrix_ * point + offset_; }
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

/// True only where one triangle lies on one side of the other's plane, farther from it than the
/// slack: most pairs whose boxes meet. The corners of either may be off by the slack.
bool plane_parts(const Corners& s, const Corners& t, double slack) {
  const dvec3 u = s[1] - s[0];
  const dvec3 v = s[2] - s[0];
  const dvec3 normal = glm::cross(u, v);
  const dvec3 heights(glm::dot(normal, t[0] - s[0]), glm::dot(normal, t[1] - s[0]),
                      glm::dot(normal, t[2] - s[0]));
  const double lengths = glm::length(u) + glm::length(v);
  const double farthest =
      std::sqrt(std::max({glm::dot(t[0] - s[0], t[0] - s[0]), glm::dot(t[1] - s[0], t[1] - s[0]),
                          glm::dot(t[2] - s[0], t[2] - s[0])}));
  // The normal may be off by 2 slack · lengths, a corner from another by 2 slack.
  const double margin = 4.0 * (slack + 1e-13 * farthest) * lengths * (lengths + farthest);
  return std::min({heights.x, heights.y, heights.z}) > margin ||
         std::max({heights.x, heights.y, heights.z}) < -margin;
}

Corners corners_of(const Mesh& mesh, std::uint32_t triangle) {
  return {mesh.corner(triangle, 0), mesh.corner(triangle, 1), mesh.corner(triangle, 2)};
}

/// Each corner where `map` has it.
template <class Map>
Corners mapped(const Corners& corners, const Map& map) {
  return {map(corners[0]), map(corners[1]), map(corners[2])};
}

Corners in_world(const Corners& corners, const Instance& instance) {
  return mapped(corners, [&](const dvec3& p) { return instance.world_from_element(p); });
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
      const Corners of_a = corners_of(a.mesh(), na.item);
      const Corners of_b = corners_of(b.mesh(), nb.item);
      const Corners b_in_a = mapped(of_b, in_a);
      if (plane_parts(of_a, b_in_a, in_a.slack()) || plane_parts(b_in_a, of_a, in_a.slack())) {
        continue;
      }
      const Corners s = in_world(of_a, instance_a);
      const Corners t = in_world(of_b, instance_b);
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
