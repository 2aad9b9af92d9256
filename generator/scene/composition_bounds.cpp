#include "scene/composition_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include <glm/gtc/constants.hpp>
#include <tbb/parallel_for.h>

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
std::vector<dvec3> used_vertices(const Mesh& mesh) {
  std::vector<bool> is_used(mesh.positions.size());
  for (const uvec3& triangle : mesh.triangles) {
    is_used[triangle.x] = is_used[triangle.y] = is_used[triangle.z] = true;
  }
  std::vector<dvec3> used;
  for (std::size_t i = 0; i < is_used.size(); ++i) {
    if (is_used[i]) {
      used.push_back(mesh.positions[i]);
    }
  }
  return used;
}

/// Where each instance is, for bounds_of() to look at few of them closely.
class Places {
 public:
  explicit Places(const Composition& composition) : composition_(composition) {
    for (const Composition::Element& prop : composition.props) {
      of_props_.push_back(used_vertices(prop.mesh));
    }
    std::vector<Ball> of_element;
    for (const Composition::Element& element : composition.elements) {
      vertices_.push_back(used_vertices(element.mesh));
      const Box box = bounding_box(element.mesh);
      corners_.push_back(corners_of(box));
      of_element.push_back({box.center(), 0.5 * glm::length(box.extent())});
    }
    balls_.reserve(composition.instances.size());
    for (const Instance& instance : composition.instances) {
      const Ball& ball = of_element[instance.element];
      const dvec3 center = instance.world_from_element(ball.center);
      const double magnitude = glm::length(center) + glm::length(instance.translation);
      balls_.push_back({center, instance.scale * ball.radius + 1e-12 * magnitude});
    }
    sort_outermost_first();
  }

  /// Calls `visit` with the vertices of the props, and of each instance whose ball and then a
  /// corner of whose box `stands_out`: that is asked whether a point is outside of what has been
  /// found, or within a distance of being so. As that and `visit` measure something convex, the
  /// others' vertices cannot matter.
  template <class StandsOut, class Visit>
  void for_each_outstanding_vertex(StandsOut stands_out, Visit visit) const {
    for (const std::vector<dvec3>& prop : of_props_) {
      std::ranges::for_each(prop, visit);
    }
    for (const std::uint32_t i : order_) {
      if (!stands_out(middle_, reach_[i])) {
        break;  // this one and all that come after it lie within that ball
      }
      if (!stands_out(balls_[i].center, balls_[i].radius)) {
        continue;
      }
      const Instance& instance = composition_.instances[i];
      if (std::ranges::any_of(corners_[instance.element], [&](const dvec3& corner) {
            return stands_out(instance.world_from_element(corner), 0.0);
          })) {
        for (const dvec3& vertex : vertices_[instance.element]) {
          visit(instance.world_from_element(vertex));
        }
      }
    }
  }

 private:
  /// Holds the box of an instance.
  struct Ball {
    dvec3 center;
    double radius;
  };

  /// So that few of the later ones stand out.
  void sort_outermost_first() {
    Box centers;
    for (const Ball& ball : balls_) {
      centers.include(ball.center);
    }
    middle_ = centers.center();
    reach_.reserve(balls_.size());
    for (const Ball& ball : balls_) {
      reach_.push_back((glm::distance(ball.center, middle_) + ball.radius) * (1.0 + 1e-12));
    }
    order_.resize(balls_.size());
    std::iota(order_.begin(), order_.end(), 0U);
    std::ranges::stable_sort(order_, std::greater<>(), [&](std::uint32_t i) { return reach_[i]; });
  }

  const Composition& composition_;
  std::vector<std::vector<dvec3>> of_props_;
  /// Of each element.
  std::vector<std::vector<dvec3>> vertices_;
  std::vector<Corners> corners_;
  std::vector<Ball> balls_;
  dvec3 middle_{0.0};
  /// How far each ball reaches from the middle, and all with the farthest first.
  std::vector<double> reach_;
  std::vector<std::uint32_t> order_;
};

bool shows_nothing(const Composition& composition) {
  return composition.instances.empty() && composition.props.empty();
}

Box box_of_shown(const Composition& composition, const Places& places) {
  Box box;
  places.for_each_outstanding_vertex(
      [&](const dvec3& p, double within) {
        return glm::any(glm::lessThan(p - within, box.min)) ||
               glm::any(glm::greaterThan(p + within, box.max));
      },
      [&](const dvec3& p) { box.include(p); });
  return shows_nothing(composition) ? composition.target_box : box;
}

double radius_round(const dvec3& axis, std::span<const dvec3> target, const Places& places) {
  const auto distance = [&](const dvec3& p) { return std::hypot(p.x - axis.x, p.z - axis.z); };
  double radius = 0.0;
  const auto include = [&](const dvec3& p) { radius = std::max(radius, distance(p)); };
  std::ranges::for_each(target, include);
  places.for_each_outstanding_vertex(
      [&](const dvec3& p, double within) { return distance(p) + within > radius; }, include);
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
  const std::vector<dvec3> toward = directions();
  std::vector<dvec3> outline(toward.size(), dvec3(0.0));
  tbb::parallel_for(std::size_t{0}, toward.size(), [&](std::size_t k) {
    double distance = -std::numeric_limits<double>::infinity();
    const auto stands_out = [&](const dvec3& p, double within) {
      return glm::dot(p, toward[k]) + within > distance;
    };
    visit_points(stands_out, [&](const dvec3& p) {
      if (stands_out(p, 0.0)) {
        distance = glm::dot(p, toward[k]);
        outline[k] = p;
      }
    });
  });
  return outline;
}

}  // namespace

CompositionBounds bounds_of(const Composition& composition) {
  const Places places(composition);
  CompositionBounds bounds;
  bounds.shown = box_of_shown(composition, places);
  Box both = bounds.shown;
  if (composition.target != nullptr) {
    both.include(composition.target_box.min);
    both.include(composition.target_box.max);
  }
  const std::vector<dvec3> target =
      composition.target != nullptr ? used_vertices(*composition.target) : std::vector<dvec3>();
  bounds.radius = radius_round(both.center(), target, places);
  const Corners corners = corners_of(composition.target_box);
  bounds.outline = {corners.begin(), corners.end()};
  bounds.target_outline = bounds.outline;
  if (!shows_nothing(composition)) {
    bounds.outline = outline_of([&](auto stands_out, auto visit) {
      places.for_each_outstanding_vertex(stands_out, visit);
    });
  }
  if (composition.target != nullptr) {
    bounds.target_outline =
        outline_of([&](auto, auto visit) { std::ranges::for_each(target, visit); });
  }
  return bounds;
}

}  // namespace collage
