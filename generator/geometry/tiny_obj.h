#pragma once

// tinyobjloader with the number type of Debian's libtinyobjloader_double; the header by itself
// means the other library.
#ifndef TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_USE_DOUBLE
#endif
#include <cmath>

#include <tiny_obj_loader.h>

namespace collage {

/// tinyobjloader's number reader is off by some ulps, "0.3" comes out as 0.30000000000000004: the
/// nearest number with twelve decimals is the one that was written.
inline double tidy(double value) {
  const double rounded = std::round(value * 1e12) / 1e12;
  return std::isfinite(rounded) ? rounded : value;
}

}  // namespace collage
