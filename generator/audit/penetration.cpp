#include "audit/penetration.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "geometry/boxes.h"
#include "geometry/closest_point.h"

namespace collage {
namespace {

double distance_to_surface(const AuditShape& shape, const dvec3& point) {
  double best = std::numeric_limits<double>::infinity();
  std::array<std::uint32_t, BoxTree::deepest> stack;
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t index = stack[--depth];
    const BoxTree::Node& node = shape.tree().nodes()[index];
    if (squared_distance(node.box, point) >= best * best) {
      continue;
    }
    if (node.is_leaf()) {
      const Mesh& mesh = shape.mesh();
      const dvec3 closest = closest_point_on_triangle(
          point, mesh.corner(node.item, 0), mesh.corner(node.item, 1), mesh.corner(node.item, 2));
      best = std::min(best, glm::distance(point, closest));
    } else {
      stack[depth++] = node.second_child;
      stack[depth++] = index + 1;
    }
  }
  return best;
}

/// Where a line through a and b crosses a triangle, 0 at a and 1 at b (Möller and Trumbore 1997).
std::optional<double> crossing(const dvec3& a, const dvec3& b, const Mesh& mesh, std::uint32_t t) {
  const dvec3 corner = mesh.corner(t, 0);
  const dvec3 u = mesh.corner(t, 1) - corner;
  const dvec3 v = mesh.corner(t, 2) - corner;
  const dvec3 p = glm::cross(b - a, v);
  const double determinant = glm::dot(u, p);
  const dvec3 from_corner = a - corner;
  const dvec3 q = glm::cross(from_corner, u);
  const double at_u = glm::dot(from_corner, p) / determinant;
  const double at_v = glm::dot(b - a, q) / determinant;
  const bool within = at_u >= 0.0 && at_v >= 0.0 && at_u + at_v <= 1.0;  // not where NaN
  return within ? std::optional(glm::dot(v, q) / determinant) : std::nullopt;
}

/// The depth of one mesh's vertices and edges in another.
class Intruder {
 public:
  Intruder(const AuditShape& host, const Instance& host_instance, const AuditShape& guest,
           const Instance& guest_instance)
      : host_(host), guest_(guest.mesh()) {
    vertices_.reserve(guest_.positions.size());
    for (const dvec3& position : guest_.positions) {
      vertices_.push_back(
          host_instance.element_from_world(guest_instance.world_from_element(position)));
    }
  }

  /// In the host's units.
  double depth() {
    for (const uvec3& triangle : guest_.triangles) {
      for (int k = 0; k < 3; ++k) {
        const dvec3& a = vertices_[triangle[k]];
        try_point(a);
        try_edge(a, vertices_[triangle[(k + 1) % 3]]);
      }
    }
    return depth_;
  }

 private:
  void try_point(const dvec3& point) {
    if (squared_distance(host_.box(), point) > 0.0 || !host_.holds(point)) {
      return;
    }
    depth_ = std::max(depth_, distance_to_surface(host_, point));
  }

  void try_edge(const dvec3& a, const dvec3& b) {
    Box box;
    box.include(a);
    box.include(b);
    crossings_.clear();
    host_.tree().find(box, [&](std::uint32_t triangle) {
      const auto at = crossing(a, b, host_.mesh(), triangle);
      if (at && *at >= 0.0 && *at <= 1.0) {
        crossings_.push_back(*at);
      }
    });
    std::ranges::sort(crossings_);
    for (std::size_t i = 1; i < crossings_.size(); ++i) {
      try_point(a + 0.5 * (crossings_[i - 1] + crossings_[i]) * (b - a));
    }
  }

  const AuditShape& host_;
  const Mesh& guest_;
  std::vector<dvec3> vertices_;
  std::vector<double> crossings_;
  double depth_ = 0.0;
};

}  // namespace

double penetration_depth(const AuditShape& a, const Instance& instance_a, const AuditShape& b,
                         const Instance& instance_b) {
  return std::max(instance_a.scale * Intruder(a, instance_a, b, instance_b).depth(),
                  instance_b.scale * Intruder(b, instance_b, a, instance_a).depth());
}

}  // namespace collage
