#pragma once

#include <vector>

#include "geometry/instanced_scene.h"
#include "preview/framing.h"

namespace collage {

/// The soft shadow of a sculpture on the studio's floor, as Compute_Shadow of
/// templates/collage-floor.inc: rays from a grid of points on the floor, finer towards the middle,
/// to the lights; smooth between the points by a cubic B-spline, so that there is no noise.
class FloorShadow {
 public:
  /// On all threads. Cost: 64 rays a point of a grid of 48 × 48.
  FloorShadow(const InstancedScene& sculpture, const Stand& stand, const Bearing& bearing);

  /// Share of the light that does not arrive at the point (x, 0, z), 0 to 1; it fades to 0 towards
  /// the shadow's edge.
  [[nodiscard]] double stopped(double x, double z) const;

 private:
  static constexpr int steps = 48;
  /// Points −1 to steps + 1 along each axis: one beyond each side for the spline.
  static constexpr int side = steps + 3;

  /// A step's place on the way across the shadow, −1 to 1, and back; steps are twice as close in
  /// the middle as on average.
  static double place(double step);
  static double step_at(double place);
  [[nodiscard]] double& at(int i, int j) {
    return stopped_[static_cast<std::size_t>((j + 1) * side + i + 1)];
  }

  double radius_;
  std::vector<double> stopped_ = std::vector<double>(std::size_t{side} * side);
};

}  // namespace collage
