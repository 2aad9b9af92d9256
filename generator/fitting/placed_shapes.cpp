#include "fitting/placed_shapes.h"

#include <algorithm>
#include <cmath>

namespace collage {

void PlacedShapes::add(const ShapedElement& shape, const Pose& pose, const Instance& instance) {
  instances_.push_back(instance);
  shapes_.push_back(&shape);
  poses_.push_back(pose);
}

void PlacedShapes::find_near(const dvec3& center, double reach, std::uint32_t first,
                             std::vector<std::uint32_t>& ids) const {
  constexpr double rounding = 1.0 + 1e-6;
  ids.clear();
  space_.visit_near(center, reach, first, [&](std::uint32_t other) {
    const Pose& pose = poses_[other];
    const dvec3 arm = center - pose.center;
    const double ball = rounding * (reach + pose.radius);
    if (glm::dot(arm, arm) <= ball * ball) {
      ids.push_back(other);
    }
  });
  std::ranges::sort(ids);
  const auto repeated = std::ranges::unique(ids);
  ids.erase(repeated.begin(), repeated.end());
}

/// Distances change by no more than the way one goes, here from a cell's corners.
double PlacedShapes::least_distance(std::uint32_t i, const dvec3& point) const {
  const Pose& pose = poses_[i];
  const DistanceField& distances = shapes_[i]->distances();
  const dvec3 unit = glm::conjugate(pose.rotation) * ((point - pose.center) / pose.radius);
  const double to_ball = glm::length(unit) - 1.0;
  const glm::vec3 steps(distances.steps(unit));
  if (!distances.holds(steps)) {
    return pose.radius * to_ball;
  }
  const double error = std::sqrt(3.0) * distances.spacing();
  return pose.radius * std::max(to_ball, distances.value(steps) - error);
}

void PlacedShapes::find_surroundings(const Pose& pose, std::uint32_t first,
                                     std::vector<std::uint32_t>& ids,
                                     Surroundings& surroundings) const {
  // Sees all that is near the ball of this radius, in which the pose stays.
  const double reach = 1.3 * pose.radius;
  find_near(pose.center, reach + spacing_, first, ids);
  surroundings.reset(pose.center, reach, first == 0 ? &space_.target_distances() : nullptr);
  for (const std::uint32_t other : ids) {
    if (least_distance(other, pose.center) < reach + spacing_) {
      surroundings.add(*shapes_[other], poses_[other]);
    }
  }
}

bool PlacedShapes::leaves_target(const ShapedElement& shape, const Instance& instance) const {
  if (target_.surface != nullptr) {
    return surfaces_come_within(spacing_, *target_.surface, Instance{}, shape.collision(),
                                instance) ||
           has_part_outside(*target_.surface, shape.collision(), instance);
  }
  const double unit = instance.scale * shape.element().size();
  return std::ranges::any_of(shape.cover().spheres, [&](const Sphere& sphere) {
    const dvec3 center =
        instance.world_from_element(shape.element().solid().mesh_from_unit(sphere.center));
    return target_.target.clearance(center) < unit * sphere.radius + spacing_;
  });
}

bool PlacedShapes::blocks(const ShapedElement& shape, const Pose& pose, Linking linking,
                          std::vector<std::uint32_t>& ids) const {
  const Instance instance = pose.instance(0, shape.element());
  const CollisionShape& own = shape.collision();
  find_near(pose.center, pose.radius + spacing_, 0, ids);
  const bool meets = std::ranges::any_of(ids, [&](std::uint32_t other) {
    constexpr double rounding = 1.0 + 1e-6;
    if (least_distance(other, pose.center) > rounding * (pose.radius + spacing_)) {
      return false;
    }
    const Instance& neighbour = instances_[other];
    const CollisionShape& its = shapes_[other]->collision();
    return surfaces_come_within(spacing_, its, neighbour, own, instance) ||
           has_part_inside(its, neighbour, own, instance) ||
           has_part_inside(own, instance, its, neighbour) ||
           (linking == Linking::avoid && linked(shape, pose, other));
  });
  return meets || leaves_target(shape, instance);
}

bool PlacedShapes::linked(const ShapedElement& shape, const Pose& pose, std::uint32_t other) const {
  const auto in_world = [](const Loop& loop, const Pose& where) {
    Loop moved = loop;
    for (dvec3& point : moved) {
      point = where.center + where.rotation * (where.radius * point);
    }
    return moved;
  };
  return std::ranges::any_of(shape.loops(), [&](const Loop& loop) {
    const Loop own = in_world(loop, pose);
    return std::ranges::any_of(shapes_[other]->loops(), [&](const Loop& its_loop) {
      return linking_number(own, in_world(its_loop, poses_[other])) != 0;
    });
  });
}

PoseFinder::Opening PlacedShapes::opening_of(std::uint32_t host) const {
  const Loop& ring = *shapes_[host]->ring();
  const Pose& pose = poses_[host];
  dvec3 middle(0.0);
  for (const dvec3& point : ring) {
    middle += point / static_cast<double>(ring.size());
  }
  return {pose.center + pose.rotation * (pose.radius * middle),
          pose.rotation * glm::normalize(area_vector(ring)), pose.radius};
}

}  // namespace collage
