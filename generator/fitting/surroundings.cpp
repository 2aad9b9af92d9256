#include "fitting/surroundings.h"

namespace collage {

void Surroundings::add(const ShapedElement& shape, const Pose& pose) {
  const DistanceField& distances = shape.distances();
  const glm::dmat3 rotation = glm::mat3_cast(pose.rotation);
  const double steps_per_world = 1.0 / (pose.radius * distances.spacing());
  neighbours_.push_back({&distances, from_origin(pose.center), static_cast<float>(pose.radius),
                         glm::mat3(rotation), glm::mat3(glm::transpose(rotation) * steps_per_world),
                         glm::vec3(distances.steps(dvec3(0.0)))});
}

float Surroundings::value(const glm::vec3& point, glm::vec3& direction) const {
  float nearest = 1e30F;
  if (target_ != nullptr) {
    nearest = target_->value(glm::vec3(target_->steps(origin_ + dvec3(point))), direction);
  }
  for (const Neighbour& neighbour : neighbours_) {
    const glm::vec3 arm = point - neighbour.center;
    const float reach = nearest + neighbour.radius;
    const float squared = glm::dot(arm, arm);
    if (reach <= 0.0F || squared >= reach * reach) {
      continue;
    }
    const glm::vec3 steps = neighbour.steps_of_center + neighbour.steps_from_world * arm;
    if (neighbour.distances->holds(steps)) {
      glm::vec3 slope;
      const float distance = neighbour.distances->value(steps, slope) * neighbour.radius;
      if (distance < nearest) {
        nearest = distance;
        direction = neighbour.world_from_unit * slope;
      }
    } else {
      const float length = std::sqrt(squared);
      nearest = length - neighbour.radius;
      direction = arm / length;
    }
  }
  return nearest;
}

}  // namespace collage
