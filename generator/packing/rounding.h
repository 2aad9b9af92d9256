#pragma once

#include <cmath>
#include <limits>

namespace collage {

/// The largest float that is not above `x`.
inline float rounded_down(double x) {
  const auto nearest = static_cast<float>(x);
  return static_cast<double>(nearest) > x
             ? std::nextafter(nearest, -std::numeric_limits<float>::infinity())
             : nearest;
}

}  // namespace collage
