#pragma once

#include <span>
#include <vector>

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

/// A point of a profile in the half plane x = radius, y = height.
using ProfilePoint = dvec2;

/// The rings of a profile that is turned round the y axis, `segments` points each; the first at
/// angle `phase_radians` from +x towards -z.
std::vector<Ring> lathe(std::span<const ProfilePoint> profile, int segments, double phase_radians);

/// Replaces the normals by smooth ones: at each corner the mean of the triangles round its vertex,
/// weighted by their angles there (Thürmer and Wüthrich 1998), that are bent against the corner's
/// own triangle by less than `crease_degrees`. Cost: O(n d) with d triangles a vertex.
void set_smooth_normals(Mesh& mesh, double crease_degrees);

}  // namespace collage
