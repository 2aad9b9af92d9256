#pragma once

#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace collage {

/// A right-handed frame at a point of a curve: u × v = along. All unit vectors.
struct Frame {
  dvec3 origin;
  dvec3 along;
  dvec3 u;
  dvec3 v;

  [[nodiscard]] dvec3 point(const dvec2& p) const { return origin + p.x * u + p.y * v; }
};

/// A curve's point with its unit tangent.
struct CurvePoint {
  dvec3 position;
  dvec3 along;
};

/// Frames along a curve that turn round its tangent as little as possible: the double reflection
/// method of Wang, Jüttler, Zheng and Liu 2008, "Computation of rotation minimizing frames". The
/// first u is `up` without its part along the curve, with which it must not be in line; no two
/// points that follow each other may coincide.
std::vector<Frame> frames_along(std::span<const CurvePoint> curve, const dvec3& up);

/// The cubic Bézier curve through four control points at steps + 1 equally spaced parameters.
std::vector<CurvePoint> bezier_curve(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d,
                                     int steps);

}  // namespace collage
