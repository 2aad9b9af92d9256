#include "scene/composition_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <glm/gtc/constants.hpp>

namespace collage {
namespace {

using Corners = std::array<dvec3, 8>;

Corners corners_of(const Box& box) {
  Corners corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i] = {(i & 1) != 0 ? box.max.x : box.min.x, (i & 2) != 0 ? box.max.y : box.min.y,
                  (i & 4) != 0 ? box.max.z : box.min.z};
  }
  return corners;
}

/// Vertices that triangles use.
template <class Visit>
void for_each_vertex(const Mesh& mesh, Visit visit) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      visit(mesh.corner(t, k));
    }
  }
}

/// Calls `visit` with the vertices of the props, and of each instance that has a corner for which
/// `stands_out`. As that and `visit` measure something convex, the others' vertices cannot matter.
template <class StandsOut, class Visit>
void for_each_outstanding_vertex(const Composition& composition, StandsOut stands_out,
                                 Visit visit) {
  for (const Composition::Element& prop : composition.props) {
    for_each_vertex(prop.mesh, visit);
  }
  std::vector<Corners> corners;
  for (const Composition::Element& element : composition.elements) {
    corners.push_back(corners_of(bounding_box(element.mesh)));
  }
  for (const Instance& instance : composition.instances) {
    const Corners& of_element = corners[instance.element];
    if (std::any_of(of_element.begin(), of_element.end(), [&](const dvec3& corner) {
          return stands_out(instance.world_from_element(corner));
        })) {
      for_each_vertex(composition.elements[instance.element].mesh,
                      [&](const dvec3& vertex) { visit(instance.world_from_element(vertex)); });
    }
  }
}

bool shows_nothing(const Composition& composition) {
  return composition.instances.empty() && composition.props.empty();
}

Box box_of_shown(const Composition& composition) {
  Box box;
  for_each_outstanding_vertex(
      composition,
      [&](const dvec3& p) {
        return glm::any(glm::lessThan(p, box.min)) || glm::any(glm::greaterThan(p, box.max));
      },
      [&](const dvec3& p) { box.include(p); });
  return shows_nothing(composition) ? composition.target_box : box;
}

double radius_round(const dvec3& axis, const Composition& composition) {
  const auto distance = [&](const dvec3& p) { return std::hypot(p.x - axis.x, p.z - axis.z); };
  double radius = 0.0;
  const auto include = [&](const dvec3& p) { radius = std::max(radius, distance(p)); };
  if (composition.target != nullptr) {
    for_each_vertex(*composition.target, include);
  }
  for_each_outstanding_vertex(
      composition, [&](const dvec3& p) { return distance(p) > radius; }, include);
  return radius;
}

/// Evenly spread unit vectors (golden angle).
std::vector<dvec3> directions() {
  constexpr int count = 128;
  std::vector<dvec3> result;
  for (int k = 0; k < count; ++k) {
    const double y = 1.0 - (2.0 * k + 1.0) / count;
    const double flat = std::sqrt(1.0 - y * y);
    const double turn = k * glm::pi<double>() * (3.0 - std::sqrt(5.0));
    result.emplace_back(flat * std::cos(turn), y, flat * std::sin(turn));
  }
  return result;
}

/// The farthest of the points that `visit_points` shows to whom it is given, in each direction.
template <class VisitPoints>
std::vector<dvec3> outline_of(VisitPoints visit_points) {
  std::vector<dvec3> outline;
  for (const dvec3& direction : directions()) {
    double distance = -std::numeric_limits<double>::infinity();
    dvec3 farthest(0.0);
    const auto stands_out = [&](const dvec3& p) { return glm::dot(p, direction) > distance; };
    visit_points(stands_out, [&](const dvec3& p) {
      if (stands_out(p)) {
        distance = glm::dot(p, direction);
        farthest = p;
      }
    });
    outline.push_back(farthest);
  }
  return outline;
}

}  // namespace

CompositionBounds bounds_of(const Composition& composition) {
  CompositionBounds bounds;
  bounds.shown = box_of_shown(composition);
  Box both = bounds.shown;
  if (composition.target != nullptr) {
    both.include(composition.target_box.min);
    both.include(composition.target_box.max);
  }
  bounds.radius = radius_round(both.center(), composition);
  const Corners corners = corners_of(composition.target_box);
  bounds.outline = {corners.begin(), corners.end()};
  bounds.target_outline = bounds.outline;
  if (!shows_nothing(composition)) {
    bounds.outline = outline_of([&](auto stands_out, auto visit) {
      for_each_outstanding_vertex(composition, stands_out, visit);
    });
  }
  if (composition.target != nullptr) {
    bounds.target_outline =
        outline_of([&](auto, auto visit) { for_each_vertex(*composition.target, visit); });
  }
  return bounds;
}

}  // namespace collage
