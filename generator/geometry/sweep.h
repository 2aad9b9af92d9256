#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/frames.h"
#include "geometry/mesh.h"

namespace collage {

/// A closed loop of points; all rings of a surface have equally many.
using Ring = std::vector<dvec3>;

/// Adds the closed surface through a stack of at least two rings: a band of triangles between each
/// two, and a fan from the middle of the first and the last ring, which seals the ends. An end ring
/// whose points coincide is a pole. Faces outwards where the rings run counter-clockwise as seen
/// from the end of the stack. Adds positions and triangles only; positions are rounded to a
/// millionth, which keeps files short and makes equal what should be.
void append_rings(Mesh& mesh, std::vector<Ring> rings);

/// Where the triangles between rings `ring` and `ring` + 1 begin in the surface that append_rings()
/// has made of rings of `points`, the first being a pole.
constexpr std::size_t band_start(std::size_t ring, std::size_t points) {
  return (2 * ring - 1) * points;
}

/// Adds the closed surface through at least three rings and from the last back to the first, as a
/// torus; otherwise as append_rings().
void append_ring_loop(Mesh& mesh, std::vector<Ring> rings);

/// A plane section, counter-clockwise, put across a curve.
Ring section_ring(const Frame& frame, std::span<const dvec2> section, double scale = 1.0);

/// `corners` points of an ellipse, counter-clockwise, the first at angle `phase_radians` from +x.
std::vector<dvec2> ellipse(double half_width, double half_height, int corners,
                           double phase_radians = 0.0);

/// A point of a profile in the half plane x = radius, y = height.
using ProfilePoint = dvec2;

/// The rings of a profile that is turned round the y axis, `segments` points each; the first at
/// angle `phase_radians` from +x towards -z.
std::vector<Ring> lathe(std::span<const ProfilePoint> profile, int segments, double phase_radians);

}  // namespace collage
