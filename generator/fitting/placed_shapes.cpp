#include "fitting/placed_shapes.h"

#include <algorithm>

namespace collage {

void PlacedShapes::add(const ShapedElement& shape, const Pose& pose, const Instance& instance) {
  instances_.push_back(instance);
  shapes_.push_back(&shape);
  poses_.push_back(pose);
}

void PlacedShapes::find_near(const dvec3& center, double reach, std::uint32_t first,
                             std::vector<std::uint32_t>& ids) const {
  ids.clear();
  space_.visit_near(center, reach, [&](std::uint32_t other) {
    if (other >= first) {
      ids.push_back(other);
    }
  });
  std::ranges::sort(ids);
  const auto repeated = std::ranges::unique(ids);
  ids.erase(repeated.begin(), repeated.end());
}

void PlacedShapes::find_surroundings(const Pose& pose, std::uint32_t first,
                                     std::vector<std::uint32_t>& ids,
                                     Surroundings& surroundings) const {
  constexpr double reach = 1.3;
  find_near(pose.center, reach * pose.radius + spacing_, first, ids);
  surroundings.reset(pose.center, first == 0 ? &space_.target_distances() : nullptr);
  for (const std::uint32_t other : ids) {
    const double together = poses_[other].radius + reach * pose.radius + spacing_;
    if (glm::distance(poses_[other].center, pose.center) < together) {
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
    const Pose& there = poses_[other];
    if (glm::distance(there.center, pose.center) > there.radius + pose.radius + spacing_) {
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
