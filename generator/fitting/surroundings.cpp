#include "fitting/surroundings.h"

namespace collage {

void Surroundings::reset(const dvec3& origin, double reach, const DistanceField* target) {
  origin_ = origin;
  target_ = target;
  neighbours_.clear();
  all_.clear();
  cell_side_ = static_cast<float>(2.0 * reach / cells_per_side);
  cells_.assign(std::size_t{cells_per_side} * cells_per_side * cells_per_side, Cell{});
  candidates_.assign(1, 0);
  nearest_before_ = 0;
}

void Surroundings::add(const ShapedElement& shape, const Pose& pose) {
  const DistanceField& distances = shape.distances();
  const glm::dmat3 rotation = glm::mat3_cast(pose.rotation);
  const double steps_per_world = 1.0 / (pose.radius * distances.spacing());
  neighbours_.push_back({&distances, &shape.distance_minima(), from_origin(pose.center),
                         static_cast<float>(pose.radius), glm::mat3(rotation),
                         glm::mat3(glm::transpose(rotation) * steps_per_world),
                         glm::vec3(distances.steps(dvec3(0.0)))});
  all_.push_back(static_cast<std::uint32_t>(all_.size()));
}

const Surroundings::Cell* Surroundings::cell_at(const glm::vec3& point) {
  constexpr std::size_t few = 4;
  const glm::vec3 steps = point / cell_side_ + 0.5F * cells_per_side;
  if (all_.size() <= few || glm::any(glm::lessThan(steps, glm::vec3(0.0F))) ||
      glm::any(glm::greaterThanEqual(steps, glm::vec3(cells_per_side)))) {
    return nullptr;
  }
  const glm::ivec3 at(steps);
  const int index = (at.z * cells_per_side + at.y) * cells_per_side + at.x;
  Cell& cell = cells_[static_cast<std::size_t>(index)];
  if (cell.first == 0) {
    cell = look_into(cell_side_ * (glm::vec3(at) + 0.5F - 0.5F * cells_per_side));
  }
  return &cell;
}

std::span<const std::uint32_t> Surroundings::candidates(const glm::vec3& point) {
  const Cell* cell = cell_at(point);
  return cell != nullptr ? std::span<const std::uint32_t>(candidates_)
                               .subspan(cell->first, cell->last - cell->first)
                         : all_;
}

Surroundings::Cell Surroundings::look_into(const glm::vec3& middle) {
  constexpr float rounding = 1.001F;
  // Half of a cell's diagonal, and how much an interpolated distance may change on the way.
  const float half = rounding * 0.8661F * cell_side_;
  const float change = rounding * 1.5F * cell_side_;
  float most = 1e30F;
  if (target_ != nullptr) {
    most = target_->value(glm::vec3(target_->steps(origin_ + dvec3(middle)))) + change;
  }
  float nearest_jump = 1e30F;
  least_.assign(neighbours_.size(), 1e30F);
  const auto look_at = [&](std::size_t n) {
    const Neighbour& neighbour = neighbours_[n];
    const glm::vec3 arm = middle - neighbour.center;
    const float ball = neighbour.radius + half + most;
    const float squared = glm::dot(arm, arm);
    if (ball < 0.0F || squared > ball * ball) {
      return;
    }
    const float to_ball = std::sqrt(squared) - neighbour.radius;
    const glm::vec3 steps = neighbour.steps(arm);
    const glm::vec3 margin(half /
                           (neighbour.radius * static_cast<float>(neighbour.distances->spacing())));
    const bool all_held =
        neighbour.distances->holds(steps - margin) && neighbour.distances->holds(steps + margin);
    if (all_held && neighbour.minima->below(steps) * neighbour.radius - change > most) {
      return;
    }
    const float distance = neighbour.distances->value(steps) * neighbour.radius;
    float greatest = distance + change;
    least_[n] = distance - change;
    if (!all_held) {
      greatest = std::max(greatest, to_ball + half);
      least_[n] = std::min(least_[n], to_ball - half);
      nearest_jump = std::min(nearest_jump, least_[n]);
    }
    if (greatest < most) {
      most = greatest;
      nearest_before_ = n;
    }
  };
  // Most of the others are out of reach as soon as one is known that is near, as often is that
  // which was the nearest in the cell before.
  const std::size_t first = nearest_before_;
  look_at(first);
  for (std::size_t n = 0; n < neighbours_.size(); ++n) {
    if (n != first) {
      look_at(n);
    }
  }
  Cell cell{static_cast<std::uint32_t>(candidates_.size()), 0, nearest_jump};
  for (const std::uint32_t n : all_) {
    if (least_[n] <= most) {
      candidates_.push_back(n);
    }
  }
  cell.last = static_cast<std::uint32_t>(candidates_.size());
  return cell;
}

float Surroundings::value(const glm::vec3& point, glm::vec3& direction, std::uint32_t& nearest) {
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
    const glm::vec3 steps = neighbour.steps(arm);
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
  for (const std::uint32_t n : candidates(point)) {
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
