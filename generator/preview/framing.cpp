#include "preview/framing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <glm/gtc/constants.hpp>

namespace collage {
namespace {

constexpr double field_of_view_degrees = 24.0;  // along the shorter side
constexpr double filled = 0.87;                 // of the picture's width and height
constexpr double lowest_eye = 0.06;
constexpr double lowest_degrees = -30.0;
constexpr double step_degrees = 0.5;
constexpr int rim_sides = 64;

/// The rims of the upright cylinder, as polygons round them.
std::vector<dvec3> rims(const Stand& stand, const Bearing& bearing) {
  const double radius = stand.radius / std::cos(glm::pi<double>() / rim_sides);
  std::vector<dvec3> points;
  for (int side = 0; side < rim_sides; ++side) {
    const double turn = glm::two_pi<double>() * side / rim_sides;
    for (const double height : {0.0, stand.height}) {
      points.push_back(turned({radius * std::cos(turn), height, radius * std::sin(turn)}, bearing));
    }
  }
  return points;
}

std::vector<dvec3> points_to_hold(const Stand& stand, const CompositionBounds& bounds,
                                  const Bearing& bearing, Framing framing) {
  if (framing == Framing::all_round) {
    return rims(stand, bearing);
  }
  std::vector<dvec3> points;
  for (const dvec3& point : bounds.outline) {
    points.push_back(stand.studio_from_world(point));
  }
  return points;
}

/// A point with the coordinates (p, q, d) to the right, up and forward is in the picture of an eye
/// at (a, e, f) if |p - a| ≤ fit_x (d - f) and |q - e| ≤ fit_y (d - f).
void stand_back(Camera& camera, const std::vector<dvec3>& held) {
  const double fit_x = filled * camera.tan_x;
  const double fit_y = filled * camera.tan_y;
  double left = std::numeric_limits<double>::max();
  double right = std::numeric_limits<double>::lowest();
  double bottom = left;
  double top = right;
  for (const dvec3& point : held) {
    const double p = glm::dot(point, camera.right);
    const double q = glm::dot(point, camera.up);
    const double d = glm::dot(point, camera.forward);
    right = std::max(right, p - fit_x * d);
    left = std::min(left, p + fit_x * d);
    top = std::max(top, q - fit_y * d);
    bottom = std::min(bottom, q + fit_y * d);
  }
  const double depth = std::min((left - right) / (2.0 * fit_x), (bottom - top) / (2.0 * fit_y));
  camera.eye = 0.5 * (left + right) * camera.right + 0.5 * (top + bottom) * camera.up +
               depth * camera.forward;
}

}  // namespace

Instance Stand::studio_from_world(const Instance& instance) const {
  return {instance.element, unit * instance.scale, instance.rotation,
          studio_from_world(instance.translation)};
}

Stand stand_of(const Composition& composition, const CompositionBounds& bounds, Standing standing) {
  Box both = bounds.shown;
  if (composition.target != nullptr) {
    both.include(composition.target_box.min);
    both.include(composition.target_box.max);
  }
  const double ground = standing == Standing::target_too ? both.min.y : bounds.shown.min.y;
  const double height = both.max.y - ground;
  Stand stand;
  stand.foot = {both.center().x, ground, both.center().z};
  stand.unit = 2.0 / std::max({height, 2.0 * bounds.radius, 1e-9});
  stand.radius = bounds.radius * stand.unit;
  stand.height = height * stand.unit;
  return stand;
}

dvec3 turned(const dvec3& direction, const Bearing& bearing) {
  const double sine = std::sin(glm::radians(bearing.azimuth_degrees));
  const double cosine = std::cos(glm::radians(bearing.azimuth_degrees));
  return {cosine * direction.x + sine * direction.z, direction.y,
          cosine * direction.z - sine * direction.x};
}

dvec3 Camera::direction(double across, double upward) const {
  return glm::normalize(forward + across * tan_x * right + upward * tan_y * up);
}

Camera frame(const Stand& stand, const CompositionBounds& bounds, const Bearing& bearing,
             double aspect, Framing framing) {
  const std::vector<dvec3> held = points_to_hold(stand, bounds, bearing, framing);
  const double tan_short = std::tan(glm::radians(0.5 * field_of_view_degrees));
  Camera camera;
  camera.tan_x = tan_short * std::max(1.0, aspect);
  camera.tan_y = tan_short * std::max(1.0, 1.0 / aspect);
  camera.right = turned({1, 0, 0}, bearing);
  double tilt_degrees = std::clamp(bearing.elevation_degrees, lowest_degrees, 90.0);
  for (;; tilt_degrees += step_degrees) {
    const double tilt = glm::radians(tilt_degrees);
    camera.forward = turned({0, -std::sin(tilt), -std::cos(tilt)}, bearing);
    camera.up = turned({0, std::cos(tilt), -std::sin(tilt)}, bearing);
    stand_back(camera, held);
    if (camera.eye.y >= lowest_eye || tilt_degrees >= 90.0) {
      return camera;
    }
  }
}

}  // namespace collage
