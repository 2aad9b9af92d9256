#include "fitting/surroundings.h"

namespace collage {

void Surroundings::add(const ShapedElement& shape, const Pose& pose) {
  const DistanceField& distances = shape.distances();
  const glm::dmat3 rotation = glm::mat3_cast(pose.rotation);
  const double steps_per_world = 1.0 / (pose.radius * distances.spacing());
  neighbours_.push_back({&distances, &shape.distance_minima(), from_origin(pose.center),
                         static_cast<float>(pose.radius), glm::mat3(rotation),
                         glm::mat3(glm::transpose(rotation) * steps_per_world),
                         glm::vec3(distances.steps(dvec3(0.0)))});
}

float Surroundings::value(const glm::vec3& point, glm::vec3& direction,
                          std::uint32_t& nearest) const {
  float least = 1e30F;
  glm::vec3 target_steps;
  if (target_ != nullptr) {
    target_steps = glm::vec3(target_->steps(origin_ + dvec3(point)));
    least = target_->value(target_steps);
  }
  const Neighbour* nearest_neighbour = nullptr;
  glm::vec3 nearest_steps;
  const auto look_at = [&](const Neighbour& neighbour) {
    const glm::vec3 arm = point - neighbour.center;
    const float reach = least + neighbour.radius;
    const float squared = glm::dot(arm, arm);
    if (reach <= 0.0F || squared >= reach * reach) {
      return;
    }
    const glm::vec3 steps = neighbour.steps_of_center + neighbour.steps_from_world * arm;
    float distance = 0.0F;
    if (!neighbour.distances->holds(steps)) {
      distance = std::sqrt(squared) - neighbour.radius;
    } else if (neighbour.minima->below(steps) * neighbour.radius < least) {
      distance = neighbour.distances->value(steps) * neighbour.radius;
    } else {
      return;
    }
    if (distance < least) {
      least = distance;
      nearest_neighbour = &neighbour;
      nearest_steps = steps;
    }
  };
  const std::uint32_t first = nearest;
  if (first < neighbours_.size()) {
    look_at(neighbours_[first]);
  }
  for (std::uint32_t n = 0; n < neighbours_.size(); ++n) {
    if (n != first) {
      look_at(neighbours_[n]);
    }
  }
  if (nearest_neighbour == nullptr) {
    if (target_ != nullptr) {
      target_->value(target_steps, direction);
    }
    return least;
  }
  nearest = static_cast<std::uint32_t>(nearest_neighbour - neighbours_.data());
  if (nearest_neighbour->distances->holds(nearest_steps)) {
    glm::vec3 slope;
    nearest_neighbour->distances->value(nearest_steps, slope);
    direction = nearest_neighbour->world_from_unit * slope;
  } else {
    direction = glm::normalize(point - nearest_neighbour->center);
  }
  return least;
}

}  // namespace collage
