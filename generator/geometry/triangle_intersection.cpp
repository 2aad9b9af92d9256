#include "geometry/triangle_intersection.h"

#include <algorithm>
#include <cmath>

#include "geometry/predicates.h"

namespace collage {
namespace {

using glm::dvec2;
using glm::dvec3;
using Signs = std::array<int, 3>;

/// On which side of the plane of t each corner of s lies.
Signs sides(const Corners& s, const Corners& t) {
  return {orient3d(t[0], t[1], t[2], s[0]), orient3d(t[0], t[1], t[2], s[1]),
          orient3d(t[0], t[1], t[2], s[2])};
}

bool all_on_one_side(const Signs& signs) {
  return signs[0] != 0 && signs[0] == signs[1] && signs[0] == signs[2];
}

bool all_zero(const Signs& signs) { return signs[0] == 0 && signs[1] == 0 && signs[2] == 0; }

bool no_opposite_signs(int a, int b, int c) {
  return std::min({a, b, c}) >= 0 || std::max({a, b, c}) <= 0;
}

bool in_interval(double x, double a, double b) {
  return std::min(a, b) <= x && x <= std::max(a, b);
}

/// For points in line.
bool between(const dvec2& p, const dvec2& a, const dvec2& b) {
  return in_interval(p.x, a.x, b.x) && in_interval(p.y, a.y, b.y);
}

bool segments_intersect(const dvec2& a, const dvec2& b, const dvec2& c, const dvec2& d) {
  const int abc = orient2d(a, b, c);
  const int abd = orient2d(a, b, d);
  const int cda = orient2d(c, d, a);
  const int cdb = orient2d(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) {
    return true;
  }
  return (abc == 0 && between(c, a, b)) || (abd == 0 && between(d, a, b)) ||
         (cda == 0 && between(a, c, d)) || (cdb == 0 && between(b, c, d));
}

using Corners2 = std::array<dvec2, 3>;

bool holds(const Corners2& t, const dvec2& p) {
  const int a = orient2d(t[0], t[1], p);
  const int b = orient2d(t[1], t[2], p);
  const int c = orient2d(t[2], t[0], p);
  // A triangle without area holds nothing but its edges, which are looked at apart.
  return no_opposite_signs(a, b, c) && orient2d(t[0], t[1], t[2]) != 0;
}

Corners2 without_axis(const Corners& t, int axis) {
  Corners2 flat;
  for (std::size_t k = 0; k < 3; ++k) {
    flat[k] = axis == 0   ? dvec2(t[k].y, t[k].z)
              : axis == 1 ? dvec2(t[k].z, t[k].x)
                          : dvec2(t[k].x, t[k].y);
  }
  return flat;
}

bool intersect_flat(const Corners2& s, const Corners2& t) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (segments_intersect(s[i], s[(i + 1) % 3], t[j], t[(j + 1) % 3])) {
        return true;
      }
    }
  }
  return holds(t, s[0]) || holds(s, t[0]);
}

/// All six corners in one plane: a projection that keeps the plane flat decides. Triangles without
/// area may lie in many planes; they meet where they do in all three projections.
bool intersect_coplanar(const Corners& s, const Corners& t) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!intersect_flat(without_axis(s, axis), without_axis(t, axis))) {
      return false;
    }
  }
  return true;
}

/// Segment pq, whose ends do not both lie in the plane of t.
bool segment_meets(const dvec3& p, const dvec3& q, int side_p, int side_q, const Corners& t) {
  if (side_p == side_q) {
    return false;  // on one side, or both in the plane: then another edge decides
  }
  if (side_p * side_q > 0) {
    return false;
  }
  return no_opposite_signs(orient3d(p, q, t[0], t[1]), orient3d(p, q, t[1], t[2]),
                           orient3d(p, q, t[2], t[0]));
}

bool edges_meet(const Corners& s, const Signs& side, const Corners& t) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (segment_meets(s[k], s[next], side[k], side[next], t)) {
      return true;
    }
  }
  return false;
}

}  // namespace

bool triangles_intersect(const Corners& s, const Corners& t) {
  const Signs side_s = sides(s, t);
  if (all_on_one_side(side_s)) {
    return false;
  }
  const Signs side_t = sides(t, s);
  if (all_on_one_side(side_t)) {
    return false;
  }
  if (all_zero(side_s) || all_zero(side_t)) {
    return intersect_coplanar(s, t);
  }
  // Where planes cross, the common segment ends on an edge of one of the two.
  return edges_meet(s, side_s, t) || edges_meet(t, side_t, s);
}

}  // namespace collage
