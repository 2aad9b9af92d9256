#include "fitting/shaped_element.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/surface_points.h"

namespace collage {
namespace {

/// The optimiser gives away this share of the bulge, or of the depth where that is less. With more
/// it finds its way through thin walls, with less it leaves room where spheres reach beyond the
/// solid.
constexpr double trusted = 0.5;
constexpr int distance_points = 100;
constexpr double distance_margin = 0.15;

/// The direction of the greatest variance of the surface, by power iteration.
dvec3 find_long_axis(const Mesh& mesh) {
  const auto points = spread_over_surface(mesh, 2000);
  dvec3 mean(0.0);
  for (const SurfacePoint& point : points) {
    mean += point.position / static_cast<double>(points.size());
  }
  dvec3 axis = glm::normalize(dvec3(0.3, 0.5, 0.8));
  for (int i = 0; i < 50; ++i) {
    dvec3 next(0.0);
    for (const SurfacePoint& point : points) {
      const dvec3 arm = point.position - mean;
      next += arm * glm::dot(arm, axis);
    }
    const double length = glm::length(next);
    axis = length > 0.0 ? next / length : axis;
  }
  return axis;
}

Sphere deepest(const SphereCover& cover) {
  const auto largest = std::ranges::max_element(cover.spheres, {}, &Sphere::radius);
  return {largest->center, std::max(0.0, largest->radius - cover.bulge)};
}

/// Place of a point of the cube [-1, 1]³ on Morton's curve, with 10 bits an axis.
std::uint32_t morton_code(const glm::vec3& point) {
  std::uint32_t code = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto steps =
        static_cast<std::uint32_t>(glm::clamp(point[axis] + 1.0F, 0.0F, 1.99F) * 512.0F);
    for (int bit = 0; bit < 10; ++bit) {
      code |= (steps >> bit & 1U) << (3 * bit + axis);
    }
  }
  return code;
}

std::vector<Loop> find_loops(const Mesh& unit_mesh) {
  constexpr std::size_t most_loops = 8;
  std::vector<Loop> loops = handle_loops(unit_mesh);
  return loops.size() <= most_loops ? loops : std::vector<Loop>{};
}

}  // namespace

dvec3 area_vector(const Loop& loop) {
  dvec3 sum(0.0);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    sum += glm::cross(loop[i], loop[(i + 1) % loop.size()]);
  }
  return sum;
}

SphereSet::SphereSet(const SphereCover& cover, double trusted) {
  for (const Sphere& sphere : cover.spheres) {
    centers.emplace_back(sphere.center);
    const double given_away = trusted * std::min(cover.bulge, sphere.radius - cover.bulge);
    radii.push_back(static_cast<float>(sphere.radius - std::max(0.0, given_away)));
  }
  order.resize(centers.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return morton_code(centers[i]); });
}

ShapeData measure_shape(const Mesh& mesh, const Element& element) {
  const SphereCoverer coverer(element.solid(),
                              in_unit_frame(mesh, element.center(), element.size()));
  return {coverer.cover(coarse_spheres), coverer.cover(fine_spheres),
          sample_unit_distances(element.solid(), distance_points, distance_margin)};
}

ShapedElement::ShapedElement(const Mesh& mesh, const Element& element, ShapeData data)
    : element_(&element),
      collision_(mesh, element.solid()),
      data_(std::move(data)),
      minima_(data_.distances),
      coarse_(data_.coarse, trusted),
      fine_(data_.fine, trusted),
      cautious_(data_.fine, 0.0),
      unit_volume_(std::abs(element.solid().volume()) / std::pow(element.size(), 3.0)),
      inscribed_(deepest(data_.fine)),
      long_axis_(find_long_axis(mesh)),
      loops_(find_loops(in_unit_frame(mesh, element.center(), element.size()))) {
  for (std::size_t l = 1; l < loops_.size(); ++l) {
    if (glm::length(area_vector(loops_[l])) > glm::length(area_vector(loops_[ring_]))) {
      ring_ = l;
    }
  }
}

}  // namespace collage
