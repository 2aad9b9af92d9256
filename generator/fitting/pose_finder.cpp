#include "fitting/pose_finder.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "packing/orientation.h"

namespace collage {
namespace {

constexpr double starts_of_new_hole = 6.0;
constexpr double starts_of_old_hole = 3.0;
constexpr double finalists = 3.0;

/// Even over the sphere where u and v are even over [0, 1).
dvec3 direction_on_sphere(double u, double v) {
  const double z = 2.0 * u - 1.0;
  const double around = glm::two_pi<double>() * v;
  const double across = std::sqrt(std::max(0.0, 1.0 - z * z));
  return {across * std::cos(around), across * std::sin(around), z};
}

glm::dquat random_rotation(Rng& rng) {
  const double u = rng.uniform();
  const dvec3 axis = direction_on_sphere(u, rng.uniform());
  return orientation({0.0, 0.0, 1.0}, axis, glm::two_pi<double>() * rng.uniform());
}

}  // namespace

/// The direction in which a ball of a fifth of the hole's size gets farthest to both sides.
dvec3 PoseFinder::longest_chord(const dvec3& hole) const {
  constexpr int directions = 64;
  constexpr int most_steps = 60;
  constexpr double ball = 0.2;
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  const DistanceField& distances = space_.distances();
  const auto distance_at = [&](const dvec3& point) {
    return static_cast<double>(distances.value(glm::vec3(distances.steps(point))));
  };
  const double least = ball * distance_at(hole);
  double longest = -1.0;
  dvec3 best(0.0, 0.0, 1.0);
  for (int i = 0; i < directions; ++i) {
    const dvec3 direction = direction_on_sphere((i + 0.5) / directions, glm::fract(i * golden));
    double length = 0.0;
    for (const double sign : {1.0, -1.0}) {
      double way = 0.0;
      for (int step = 0; step < most_steps; ++step) {
        const double distance = distance_at(hole + sign * way * direction);
        if (distance < least) {
          break;
        }
        way += std::max(0.5 * distance, 0.5 * distances.spacing());
      }
      length += way;
    }
    if (length > longest) {
      longest = length;
      best = direction;
    }
  }
  return best;
}

void PoseFinder::add_starts(const Request& request, Rng& rng) {
  poses_.clear();
  const ShapedElement& shape = request.shape;
  double starts = request.effort * starts_of_new_hole;
  if (request.previous.radius > 0.0) {
    poses_.push_back(request.previous);
    poses_.back().radius *= 0.95;
    starts = request.effort * starts_of_old_hole;
  }
  const dvec3 chord = longest_chord(request.hole);
  for (int i = 0; i < starts; ++i) {
    const bool along_chord = 2.0 * i < starts;
    const dvec3 way = i % 2 == 0 ? chord : -chord;
    const glm::dquat rotation =
        along_chord ? orientation(shape.long_axis(), way, glm::two_pi<double>() * rng.uniform())
                    : random_rotation(rng);
    dvec3 anchor(0.0);
    if (i % 3 == 1) {
      anchor = shape.inscribed().center;
    } else if (i % 3 == 2) {
      anchor = dvec3(shape.coarse().centers[rng.below(shape.coarse().centers.size())]);
    }
    const Pose pose =
        optimizer_.grow(shape.coarse(), rotation, anchor, request.hole, request.largest_radius);
    if (pose.radius > 0.0) {
      poses_.push_back(pose);
    }
  }
}

std::span<const Pose> PoseFinder::find(const Request& request, Rng& rng) {
  add_starts(request, rng);
  return refine(request, rng);
}

std::span<const Pose> PoseFinder::find_linked(const Request& request, const Opening& opening,
                                              Rng& rng) {
  constexpr int starts = 16;
  const Loop& ring = *request.shape.ring();
  poses_.clear();
  for (int i = 0; i < starts; ++i) {
    const std::size_t at = rng.below(ring.size());
    const dvec3& before = ring[(at + ring.size() - 1) % ring.size()];
    const dvec3 along = glm::normalize(ring[(at + 1) % ring.size()] - before);
    const dvec3 through = i % 2 == 0 ? opening.axis : -opening.axis;
    Pose pose;
    pose.rotation = orientation(along, through, glm::two_pi<double>() * rng.uniform());
    pose.radius = glm::clamp(opening.radius * (0.3 + 0.8 * rng.uniform()), request.least_radius,
                             std::max(request.least_radius, request.largest_radius));
    pose.center = opening.center - pose.rotation * (pose.radius * ring[at]);
    poses_.push_back(pose);
  }
  return refine(request, rng);
}

std::span<const Pose> PoseFinder::refine(const Request& request, Rng& rng) {
  // A start that has come half as far as the best, or as need be, may still get there; few spheres
  // reach so far beyond the element that all of them may make it a third larger.
  constexpr double hopeful = 0.55;
  constexpr double enough = 0.77;
  constexpr double worth_refining = 0.85;
  double best_radius = 0.0;
  for (Pose& pose : poses_) {
    pose =
        optimizer_.maximize(request.shape.coarse(), pose,
                            {.steps = 7,
                             .largest_radius = request.largest_radius,
                             .least_radius = hopeful * std::max(best_radius, request.least_radius)},
                            rng);
    best_radius = std::max(best_radius, pose.radius);
  }
  std::ranges::stable_sort(poses_, std::ranges::greater{}, &Pose::radius);
  found_.clear();
  double largest = 0.0;
  const auto most = static_cast<std::size_t>(finalists * std::sqrt(request.effort));
  for (std::size_t i = 0; i < std::min(most, poses_.size()); ++i) {
    if (poses_[i].radius < enough * request.least_radius ||
        poses_[i].radius < worth_refining * hopeful * largest) {
      break;
    }
    const Pose pose = optimizer_.maximize(request.shape.fine(), poses_[i],
                                          {.steps = 10,
                                           .first_step = 0.12,
                                           .largest_radius = request.largest_radius,
                                           .least_radius = hopeful * request.least_radius},
                                          rng);
    largest = std::max(largest, pose.radius);
    if (pose.radius >= request.least_radius) {
      found_.push_back(pose);
    }
  }
  std::ranges::stable_sort(found_, std::ranges::greater{}, &Pose::radius);
  return found_;
}

}  // namespace collage
