#pragma once

#include "scene/composition.h"
#include "scene/composition_bounds.h"

namespace collage {

/// Where the sculpture stands in the studio: y is up, the floor is y = 0, and the larger of the
/// sculpture's height and width is 2 units. As Frame_Sculpture of templates/collage.inc, but that
/// the camera goes round a sculpture that stays.
struct Stand {
  /// The point of the world that stands on the studio's origin.
  dvec3 foot{0.0};
  /// Studio units to a unit of the world.
  double unit = 1.0;
  /// Of the upright cylinder round the origin that holds sculpture and target, in studio units.
  double radius = 1.0;
  double height = 2.0;

  [[nodiscard]] dvec3 studio_from_world(const dvec3& point) const { return unit * (point - foot); }
  [[nodiscard]] Instance studio_from_world(const Instance& instance) const;
};

/// What stands on the floor; pictures of both lie on top of each other.
enum class Standing { sculpture, target_too };
Stand stand_of(const Composition& composition, const CompositionBounds& bounds,
               Standing standing = Standing::sculpture);

/// The angles of a picture. Azimuth 0 looks at the front, from +z; positive moves the camera to the
/// right. Elevation counts from the horizon up.
struct Bearing {
  double azimuth_degrees = 0.0;
  double elevation_degrees = 0.0;
};

/// A direction of the studio as it is for azimuth 0, where the camera has gone round to `bearing`:
/// light and backdrop go with it.
dvec3 turned(const dvec3& direction, const Bearing& bearing);

/// A perspective camera in the studio; `right`, `up` and `forward` are unit vectors.
struct Camera {
  dvec3 eye{0.0};
  dvec3 right{0.0};
  dvec3 up{0.0};
  dvec3 forward{0.0};
  /// Tangents of half the field of view.
  double tan_x = 1.0;
  double tan_y = 1.0;

  /// Unit vector through the point of the picture that is `across` to the right of its middle and
  /// `upward` above it, both from -1 to 1.
  [[nodiscard]] dvec3 direction(double across, double upward) const;
};

/// What has room in the picture: the sculpture as it is seen from there, or as it turns all round.
enum class Framing { view, all_round };

/// A camera that stands as near as it can while all of the sculpture stays inside 0.87 of a picture
/// whose width is `aspect` times its height. It never goes below 0.06 over the floor; rather it
/// rises. As Frame_Camera of templates/collage.inc, so that previews lie on top of stills.
Camera frame(const Stand& stand, const CompositionBounds& bounds, const Bearing& bearing,
             double aspect, Framing framing);

}  // namespace collage
