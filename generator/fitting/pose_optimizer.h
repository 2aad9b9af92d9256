#pragma once

#include <cstdint>
#include <vector>

#include "base/rng.h"
#include "fitting/distance_field.h"
#include "fitting/linear_program.h"
#include "fitting/pose.h"
#include "fitting/shaped_element.h"
#include "fitting/surroundings.h"

namespace collage {

/// Moves, turns and grows spheres that stand for an element until they are as large as the free
/// space allows: sequential linear programming. With motion τ and turn ω and growth σ, all in units
/// of the radius, and a penalised slack e, each sphere of centre q and radius r in the turned unit
/// frame, at distance d from the nearest surface in direction -g, must keep
///   g·τ + (q × g)·ω + (g·q - r) σ + e ≥ r - d / radius,
/// and σ - 30 e is as large as can be within a box that shrinks from step to step.
/// Keeps memory between calls; one for each thread.
class PoseOptimizer {
 public:
  /// How far spheres may reach beyond the free space, in units of the radius.
  static constexpr double tolerance = 2e-4;

  struct Options {
    int steps = 10;
    /// Largest motion, turn and growth of the first step.
    double first_step = 0.3;
    double largest_radius = 1e300;
    /// Spheres seen too far away to limit a step need not be looked at again: the result is the
    /// same.
    enum class Look { at_near_ones, at_all } look = Look::at_near_ones;
    /// Give up where half of the steps have led to less than this radius.
    double least_radius = 0.0;
  };

  /// `margin` is kept to all surfaces.
  PoseOptimizer(const DistanceField& distances, double margin)
      : distances_(distances), margin_(margin) {}

  /// From now on distances are those of `near`, which must live as long; nullptr: of the whole.
  void look_at(Surroundings* near) {
    near_ = near;
    nearest_.clear();
  }
  /// By how much the worst sphere reaches beyond the free space, in units of the radius.
  double violation(const SphereSet& spheres, const Pose& pose);
  [[nodiscard]] bool fits(const SphereSet& spheres, const Pose& pose) {
    return violation(spheres, pose) <= tolerance;
  }
  /// The pose grown from nothing round `anchor`, a point of the unit frame that stays where
  /// `at` is, until a sphere touches; radius 0 where it cannot grow.
  Pose grow(const SphereSet& spheres, const glm::dquat& rotation, const dvec3& anchor,
            const dvec3& at, double largest_radius);
  /// The largest pose found from `start`, which need not fit; radius 0 where none fits.
  Pose maximize(const SphereSet& spheres, const Pose& start, const Options& options, Rng& rng);
  /// Moves a pose that fits against its surroundings, its radius staying as it is.
  Pose hug(const SphereSet& spheres, const Pose& start);

 private:
  /// Where a sphere's distance was looked up, and what it was.
  struct Seen {
    glm::vec3 at;
    float distance;
  };
  void forget(const SphereSet& spheres) {
    seen_.assign(spheres.centers.size(), {glm::vec3(0.0F), -1e30F});
  }
  /// The same where it is positive; spheres that were seen too far away to limit a step of this
  /// size are not looked at.
  double violation_within(double step, const SphereSet& spheres, const Pose& pose);
  void add_constraints(const SphereSet& spheres, double step);
  /// Takes the step that the linear program asks for; false where there is none.
  bool take_step(Pose& pose);

  const DistanceField& distances_;
  double margin_;
  Surroundings* near_ = nullptr;
  LinearProgram program_;
  /// By sphere: centre in the turned unit frame, distance over the radius, direction of growth.
  std::vector<glm::vec3> turned_;
  std::vector<float> distance_;
  std::vector<glm::vec3> away_;
  std::vector<Seen> seen_;
  /// By sphere, which of the surroundings was the nearest before.
  std::vector<std::uint32_t> nearest_;
};

}  // namespace collage
