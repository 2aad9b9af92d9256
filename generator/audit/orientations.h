#pragma once

#include <optional>
#include <span>

#include "geometry/instance.h"

namespace collage {

/// How evenly the instances are turned.
struct Orientations {
  /// 1 perfectly even, 0 all turned alike: (4/3)(1 - tr T²) with the scatter matrix T = Σ q qᵀ / n
  /// of the unit quaternions q, in which q and -q, the same rotation, count the same. Where all are
  /// equally likely T is a quarter of the identity. The same number is 1 - ‖M‖² / 3 with the mean
  /// rotation matrix M and the sum ‖M‖² of its squared entries.
  ///
  /// So it sees whether some direction of the elements points one way more than the opposite one.
  /// Turned about one axis only, all upright, comes to 2/3. It cannot see what leaves M at 0, such
  /// as a few orientations that balance each other, and it knows nothing of the elements' own
  /// symmetry: balls turned alike count as turned alike. Kinds are taken together.
  double evenness = 0.0;
  /// What that many independent uniform rotations come to on average, 1 - 1/n.
  double expected_evenness = 0.0;
  /// Bingham's statistic of uniformity, 12 n (tr T² - 1/4) = 9 n (1 - evenness). For many uniform
  /// rotations it follows χ² of 9 degrees of freedom: 9 on average, above 21.7 in one case of a
  /// hundred (Mardia and Jupp 2000, "Directional Statistics", 10.7.1 and 13.2.2).
  double bingham = 0.0;
};

/// Nothing where there are no instances.
std::optional<Orientations> orientations(std::span<const Instance> instances);

}  // namespace collage
