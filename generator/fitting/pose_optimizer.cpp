#include "fitting/pose_optimizer.h"

#include <algorithm>
#include <cmath>

namespace collage {
namespace {

constexpr std::size_t growth = 6;
constexpr std::size_t slack = 7;
constexpr double slack_price = 30.0;
constexpr double most_slack = 4.0;
/// Of interpolated distances: 1 along each axis of the lattice.
constexpr double steepest_slope = 1.7321;

glm::dquat turned_by(const dvec3& axis_angle, const glm::dquat& rotation) {
  const double angle = glm::length(axis_angle);
  if (angle < 1e-12) {
    return rotation;
  }
  const dvec3 axis = std::sin(0.5 * angle) / angle * axis_angle;
  return glm::normalize(glm::dquat(std::cos(0.5 * angle), axis.x, axis.y, axis.z) * rotation);
}

/// With more room than this, in units of the radius, a sphere does not limit a step.
float reach(double step, const glm::vec3& center, float radius) {
  return static_cast<float>(step) * (1.4F + 2.4F * glm::length(center) + radius);
}

}  // namespace

double PoseOptimizer::violation(const SphereSet& spheres, const Pose& pose) {
  forget(spheres);
  return violation_within(0.0, spheres, pose);
}

double PoseOptimizer::violation_within(double step, const SphereSet& spheres, const Pose& pose) {
  const std::size_t count = spheres.centers.size();
  turned_.resize(count);
  distance_.resize(count);
  away_.resize(count);
  nearest_.resize(count);
  const glm::mat3 rotation(glm::mat3_cast(pose.rotation));
  const double unit = near_ != nullptr ? 1.0 : distances_.spacing();
  const glm::vec3 middle =
      near_ != nullptr ? near_->from_origin(pose.center) : glm::vec3(distances_.steps(pose.center));
  const auto radius = static_cast<float>(pose.radius / unit);
  const auto steepest = static_cast<float>(steepest_slope * unit);
  const auto units_per_world = static_cast<float>(1.0 / pose.radius);
  const auto margin = static_cast<float>(margin_);
  float worst = -1e30F;
  for (const std::size_t i : spheres.order) {
    turned_[i] = rotation * spheres.centers[i];
    const glm::vec3 at = middle + radius * turned_[i];
    Seen& seen = seen_[i];
    const auto is_out_of_reach = [&](float distance) {
      const float room = (distance - margin) * units_per_world - spheres.radii[i];
      return room > reach(step, turned_[i], spheres.radii[i]);
    };
    float least = seen.distance - steepest * glm::distance(at, seen.at);
    if (near_ != nullptr && is_out_of_reach(least)) {
      least = std::min(least, near_->nearest_jump(at));
    }
    if (is_out_of_reach(least)) {
      distance_[i] = (least - margin) * units_per_world;
      continue;
    }
    const float distance =
        near_ != nullptr ? near_->value(at, away_[i], nearest_[i]) : distances_.value(at, away_[i]);
    seen = {at, distance};
    distance_[i] = (distance - margin) * units_per_world;
    worst = std::max(worst, spheres.radii[i] - distance_[i]);
  }
  return worst;
}

Pose PoseOptimizer::grow(const SphereSet& spheres, const glm::dquat& rotation, const dvec3& anchor,
                         const dvec3& at, double largest_radius) {
  constexpr int most_steps = 40;
  constexpr double small_step = 0.003;
  const glm::mat3 matrix(glm::mat3_cast(rotation));
  const glm::vec3 middle(distances_.steps(at));
  double radius = 0.0;
  for (int i = 0; i < most_steps && radius < largest_radius; ++i) {
    const auto steps_per_unit = static_cast<float>(radius / distances_.spacing());
    double step = largest_radius - radius;
    for (std::size_t s = 0; s < spheres.centers.size(); ++s) {
      const glm::vec3 arm = matrix * (spheres.centers[s] - glm::vec3(anchor));
      const double free =
          distances_.value(middle + steps_per_unit * arm) - margin_ - radius * spheres.radii[s];
      step = std::min(step, free / (glm::length(arm) + spheres.radii[s]));
    }
    if (step <= small_step * radius) {
      break;
    }
    radius += step;
  }
  return {at - rotation * (radius * anchor), rotation, std::max(0.0, radius)};
}

void PoseOptimizer::add_constraints(const SphereSet& spheres, double step) {
  program_.clear();
  for (std::size_t i = 0; i < spheres.centers.size(); ++i) {
    const glm::vec3& q = turned_[i];
    const glm::vec3& g = away_[i];
    const float r = spheres.radii[i];
    const float room = distance_[i] - r;
    if (room > reach(step, q, r)) {
      continue;
    }
    const glm::vec3 turn = glm::cross(q, g);
    program_.add({-g.x, -g.y, -g.z, -turn.x, -turn.y, -turn.z, r - glm::dot(g, q), -1.0F}, room);
  }
}

bool PoseOptimizer::take_step(Pose& pose) {
  if (!program_.solve()) {
    return false;
  }
  const LinearProgram::Vector& x = program_.solution();
  pose.center += pose.radius * dvec3(x[0], x[1], x[2]);
  pose.rotation = turned_by(dvec3(x[3], x[4], x[5]), pose.rotation);
  pose.radius *= 1.0 + x[growth];
  return true;
}

Pose PoseOptimizer::maximize(const SphereSet& spheres, const Pose& start, const Options& options,
                             Rng& rng) {
  constexpr double decay = 0.86;
  constexpr double retreat = 0.6;
  constexpr double least_step = 1e-3;
  constexpr double noise = 1e-3;
  Pose pose = start;
  Pose best;
  double step = options.first_step;
  forget(spheres);
  for (int i = 0; i < options.steps && step >= least_step; ++i) {
    if (options.look == Options::Look::at_all) {
      forget(spheres);
    }
    if (violation_within(step, spheres, pose) <= tolerance && pose.radius > best.radius) {
      best = pose;
    }
    if (i == options.steps / 2 && std::max(best.radius, pose.radius) < options.least_radius) {
      return best;
    }
    add_constraints(spheres, step);
    for (std::size_t v = 0; v < growth; ++v) {
      program_.objective[v] = noise * (rng.uniform() - 0.5);  // of equally good corners, any one
      program_.lowest[v] = -step;
      program_.highest[v] = step;
    }
    program_.objective[growth] = 1.0;
    program_.lowest[growth] = -step;
    program_.highest[growth] =
        std::max(-step, std::min(step, options.largest_radius / pose.radius - 1.0));
    program_.objective[slack] = -slack_price;
    program_.lowest[slack] = 0.0;
    program_.highest[slack] = most_slack;
    step *= take_step(pose) ? decay : retreat;
  }
  double excess = violation_within(0.0, spheres, pose);
  for (int i = 0; i < 4 && excess > tolerance && pose.radius > best.radius; ++i) {
    pose.radius *= 1.0 - std::min(0.2, 1.3 * excess);
    excess = violation_within(0.0, spheres, pose);
  }
  return excess <= tolerance && pose.radius > best.radius ? pose : best;
}

Pose PoseOptimizer::hug(const SphereSet& spheres, const Pose& start) {
  constexpr int steps = 8;
  constexpr float near = 0.5F;
  Pose pose = start;
  Pose best = start;
  double step = 0.1;
  for (int i = 0; i < steps; ++i) {
    if (violation(spheres, pose) <= tolerance) {
      best = pose;
    }
    dvec3 pull(0.0);
    dvec3 twist(0.0);
    for (std::size_t s = 0; s < spheres.centers.size(); ++s) {
      if (distance_[s] - spheres.radii[s] < near) {
        pull -= dvec3(away_[s]);
        twist -= dvec3(glm::cross(turned_[s], away_[s]));
      }
    }
    const double size = glm::length(pull) + glm::length(twist) + 1e-9;
    add_constraints(spheres, step);
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      program_.objective[a] = pull[axis] / size;
      program_.objective[a + 3] = twist[axis] / size;
    }
    for (std::size_t v = 0; v < growth; ++v) {
      program_.lowest[v] = -step;
      program_.highest[v] = step;
    }
    program_.objective[growth] = program_.lowest[growth] = program_.highest[growth] = 0.0;
    program_.objective[slack] = -slack_price;
    program_.lowest[slack] = 0.0;
    program_.highest[slack] = most_slack;
    if (!take_step(pose)) {
      break;
    }
    step *= 0.8;
  }
  return fits(spheres, pose) ? pose : best;
}

}  // namespace collage
