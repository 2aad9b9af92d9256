#include "preview/studio.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

namespace collage {
namespace {

const dvec3 warm = 1.08 * dvec3(1.00, 0.95, 0.88);
const dvec3 cool(0.84, 0.92, 1.00);
constexpr double dome_strength = 0.88;
constexpr double rim_strength = 0.4;

constexpr int key_lamps = 8;
constexpr double key_lamp_degrees = 32.0;
constexpr int dome_lamps = 20;
constexpr double dome_lowest_degrees = -25.0;
constexpr double dome_nadir = 0.4;  // how bright the lowest are, the highest being 1

constexpr double golden_angle = 2.39996323;

/// `side_degrees` to the right of the camera, `rise_degrees` above the horizon.
dvec3 toward(double side_degrees, double rise_degrees) {
  const double side = glm::radians(side_degrees);
  const double rise = glm::radians(rise_degrees);
  return {std::cos(rise) * std::sin(side), std::sin(rise), std::cos(rise) * std::cos(side)};
}

const dvec3 key = toward(-42, 50);
const dvec3 rim = toward(140, 40);

/// Two unit vectors across a direction that is not upright.
struct Across {
  dvec3 side;
  dvec3 over;
  explicit Across(const dvec3& direction)
      : side(glm::normalize(glm::cross(dvec3(0, 1, 0), direction))),
        over(glm::cross(direction, side)) {}
};

/// A bright window: 1 inside a rectangle of `width_degrees` x `height_degrees`, with edges that
/// fade over `blur`, a share of half its width.
class Window {
 public:
  Window(const dvec3& direction, double width_degrees, double height_degrees, double blur)
      : direction_(direction), blur_(blur) {
    const Across across(direction);
    side_ = across.side / std::tan(glm::radians(0.5 * width_degrees));
    over_ = across.over / std::tan(glm::radians(0.5 * height_degrees));
  }

  [[nodiscard]] double brightness(const dvec3& seen) const {
    const double ahead = glm::dot(seen, direction_);
    if (ahead < 0.05) {
      return 0.0;
    }
    const double x = std::abs(glm::dot(seen, side_)) / ahead;
    const double y = std::abs(glm::dot(seen, over_)) / ahead;
    return std::clamp((1.0 - x) / blur_, 0.0, 1.0) * std::clamp((1.0 - y) / blur_, 0.0, 1.0);
  }

 private:
  dvec3 direction_;
  /// 1 at the rectangle's edge, a unit ahead.
  dvec3 side_;
  dvec3 over_;
  double blur_;
};

const Window key_window{key, 34, 42, 0.12};
const Window side_window{toward(70, 15), 14, 80, 0.2};
const Window back_window{rim, 40, 30, 0.4};

/// Spread evenly over a square by the plastic number (Roberts 2018, "R2").
void add_key(LampParts& parts, const Bearing& bearing) {
  const Across across(key);
  const double reach = std::tan(glm::radians(0.5 * key_lamp_degrees));
  for (int k = 0; k < key_lamps; ++k) {
    const double x = 0.5 + 0.7548776662466927 * k;
    const double y = 0.5 + 0.5698402909980532 * k;
    const dvec3 direction =
        glm::normalize(key + reach * (2.0 * (x - std::floor(x)) - 1.0) * across.side +
                       reach * (2.0 * (y - std::floor(y)) - 1.0) * across.over);
    parts[static_cast<std::size_t>(k % samples_a_pixel)].push_back(
        {turned(direction, bearing), double{samples_a_pixel} / key_lamps * warm});
  }
}

/// Spread evenly from the zenith down (golden angle), dimmer the lower they stand.
void add_dome(LampParts& parts, const Bearing& bearing) {
  const double low = std::sin(glm::radians(dome_lowest_degrees));
  for (int k = 0; k < dome_lamps; ++k) {
    const double share = (k + 0.5) / dome_lamps;
    const double rise = low + (1.0 - low) * share;
    const double flat = std::sqrt(1.0 - rise * rise);
    const double turn = golden_angle * k + 0.7;
    const double strength = 2.0 * (dome_nadir + (1.0 - dome_nadir) * share) / (1.0 + dome_nadir);
    parts[static_cast<std::size_t>(k % samples_a_pixel)].push_back(
        {turned({flat * std::cos(turn), rise, flat * std::sin(turn)}, bearing),
         samples_a_pixel * dome_strength * strength / dome_lamps * cool});
  }
}

}  // namespace

LampParts studio_lamps(const Bearing& bearing) {
  static_assert(key_lamps % samples_a_pixel == 0 && dome_lamps % samples_a_pixel == 0);
  LampParts parts;
  add_key(parts, bearing);
  add_dome(parts, bearing);
  for (std::vector<Lamp>& part : parts) {
    part.push_back({turned(rim, bearing), rim_strength * cool});
  }
  return parts;
}

Standing standing(std::string_view look) {
  return look == "x-ray" || look == "breakdown" ? Standing::target_too : Standing::sculpture;
}

std::optional<FloorLight> floor_light(std::string_view look) {
  if (look == "studio" || look == "x-ray" || look == "breakdown") {
    return FloorLight{key, 40.0, 0.4};
  }
  if (look == "clay") {
    return FloorLight{key, 40.0, 0.35};
  }
  if (look == "daylight") {
    return FloorLight{toward(-58, 38), 20.0, 0.0};
  }
  return std::nullopt;
}

double studio_room(const dvec3& direction, const Bearing& bearing) {
  const dvec3 seen = turned(direction, {-bearing.azimuth_degrees, 0.0});
  return 0.10 + 0.10 * seen.y * seen.y + 15.0 * key_window.brightness(seen) +
         3.0 * side_window.brightness(seen) + 3.0 * back_window.brightness(seen);
}

dvec3 studio_backdrop(double across, double upward) {
  const dvec3 near(0.96, 0.955, 0.945);
  const dvec3 far(0.42, 0.45, 0.50);
  const double above = std::max(0.0, upward + 0.35);
  const double below = std::min(0.0, upward + 0.35);
  const double way =
      std::sqrt(0.10 * across * across + 0.31 * above * above + 0.07 * below * below);
  return glm::mix(near, far, 0.5 - 0.5 * std::cos(glm::pi<double>() * std::min(1.0, way)));
}

dvec3 shaded_floor(const dvec3& backdrop, double stopped) {
  constexpr double depth = 0.95;
  return glm::mix(backdrop, dvec3(0.07, 0.07, 0.085), depth * stopped);
}

}  // namespace collage
