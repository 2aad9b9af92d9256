#pragma once

#include <vector>

#include "geometry/instanced_scene.h"
#include "preview/framing.h"

namespace collage {

/// The light that makes a shadow on the floor: a share of it, 0 to 1, from a lamp that appears so
/// many degrees wide, the rest from the whole sky.
struct FloorLight {
  /// Unit vector towards the lamp, as it is for azimuth 0; the lamp goes with the camera.
  dvec3 key{0.0, 1.0, 0.0};
  double key_width_degrees = 0.0;
  double key_share = 0.0;

  bool operator==(const FloorLight&) const = default;
};

/// Points along each side of the shadow, and rays from each.
struct ShadowFineness {
  int steps = 42;
  int rays = 32;
};

/// The soft shadow of a sculpture on the studio's floor, as Compute_Shadow of
/// templates/collage-floor.inc: rays from a grid of points on the floor, finer towards the middle,
/// to the lights; smooth between the points by a cubic B-spline, so that there is no noise. The
/// grid goes with the camera: its first axis points to the right of the picture, the second towards
/// the eye.
class FloorShadow {
 public:
  /// On all threads. Cost: rays · (steps + 4)² rays.
  FloorShadow(const InstancedScene& sculpture, const Stand& stand, const Bearing& bearing,
              const FloorLight& light, const ShadowFineness& fineness = {});

  /// Share of the light that does not arrive at the point (x, 0, z) of the studio, 0 to 1; it fades
  /// to 0 towards the shadow's edge.
  [[nodiscard]] double stopped(double x, double z) const;

  /// The spline's control values, (steps + 3)² of them: along the first axis, then the second, from
  /// one step beyond the shadow's edge to as much beyond the other.
  [[nodiscard]] const std::vector<double>& control_values() const { return stopped_; }
  /// How far the shadow reaches from the studio's origin.
  [[nodiscard]] double radius() const { return radius_; }
  /// Along each side.
  [[nodiscard]] int control_count() const { return steps_ + 3; }

 private:
  /// A step's place on the way across the shadow, −1 to 1, and back; steps are twice as close in
  /// the middle as on average.
  [[nodiscard]] double place(double step) const;
  [[nodiscard]] double step_at(double place) const;

  Bearing bearing_;
  int steps_;
  double radius_;
  std::vector<double> stopped_;
};

}  // namespace collage
