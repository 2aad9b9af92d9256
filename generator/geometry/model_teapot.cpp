#include <array>
#include <cassert>
#include <span>
#include <vector>

#include "geometry/models.h"
#include "geometry/smooth_normals.h"
#include "geometry/sweep.h"

namespace collage {
namespace {

/// A control loop of a part: cubic Bézier curves that follow each other round, as 3 points a curve.
using Loop = std::vector<dvec3>;

/// A control loop of a part of revolution in Newell's table: radius, height, and the offset of the
/// inner points of each quarter circle.
struct Circle {
  double radius;
  double height;
  double offset;
};

constexpr Circle circle(double radius, double height) { return {radius, height, 0.56 * radius}; }

/// Bottom, body and rim, from the table up to the rim's inner edge.
constexpr std::array pot = {
    circle(0, 0),        circle(1.425, 0), circle(1.5, 0.075),      circle(1.5, 0.15),
    circle(1.5, 0.225),  circle(2, 0.45),  circle(2, 0.9),          circle(2, 1.35),
    circle(1.75, 1.875), circle(1.5, 2.4), circle(1.4375, 2.53125), circle(1.3375, 2.53125),
    circle(1.4, 2.4),
};

/// The lid from its edge to the top of its knob.
constexpr std::array lid = {
    circle(1.3, 2.4), circle(1.3, 2.55),       circle(0.4, 2.55), circle(0.2, 2.7),
    circle(0, 2.85),  Circle{0.8, 3.15, 0.45}, circle(0, 3.15),
};

/// Half a control loop of handle or spout, from the plane z = 0 round to it again: x and y of four
/// points, and z of the inner two.
struct HalfLoop {
  std::array<dvec2, 4> points;
  double z;
};

constexpr std::array<HalfLoop, 7> handle = {{
    {{{{-1.6, 2.025}, {-1.6, 2.025}, {-1.5, 2.25}, {-1.5, 2.25}}}, 0.3},
    {{{{-2.3, 2.025}, {-2.3, 2.025}, {-2.5, 2.25}, {-2.5, 2.25}}}, 0.3},
    {{{{-2.7, 2.025}, {-2.7, 2.025}, {-3.0, 2.25}, {-3.0, 2.25}}}, 0.3},
    {{{{-2.7, 1.8}, {-2.7, 1.8}, {-3.0, 1.8}, {-3.0, 1.8}}}, 0.3},
    {{{{-2.7, 1.575}, {-2.7, 1.575}, {-3.0, 1.35}, {-3.0, 1.35}}}, 0.3},
    {{{{-2.5, 1.125}, {-2.5, 1.125}, {-2.65, 0.9375}, {-2.65, 0.9375}}}, 0.3},
    {{{{-2.0, 0.9}, {-2.0, 0.9}, {-1.9, 0.6}, {-1.9, 0.6}}}, 0.3},
}};

constexpr std::array<HalfLoop, 7> spout = {{
    {{{{1.7, 1.425}, {1.7, 1.425}, {1.7, 0.6}, {1.7, 0.6}}}, 0.66},
    {{{{2.6, 1.425}, {2.6, 1.425}, {3.1, 0.825}, {3.1, 0.825}}}, 0.66},
    {{{{2.3, 2.1}, {2.3, 2.1}, {2.4, 2.025}, {2.4, 2.025}}}, 0.25},
    {{{{2.7, 2.4}, {2.7, 2.4}, {3.3, 2.4}, {3.3, 2.4}}}, 0.25},
    {{{{2.8, 2.475}, {2.8, 2.475}, {3.525, 2.49375}, {3.525, 2.49375}}}, 0.25},
    {{{{2.9, 2.475}, {2.9, 2.475}, {3.45, 2.5125}, {3.45, 2.5125}}}, 0.15},
    {{{{2.8, 2.4}, {2.8, 2.4}, {3.2, 2.4}, {3.2, 2.4}}}, 0.15},
}};

Loop loop_of(const Circle& c) {
  const double r = c.radius;
  const double k = c.offset;
  const double y = c.height;
  return {{r, y, 0},  {r, y, -k}, {k, y, -r}, {0, y, -r}, {-k, y, -r}, {-r, y, -k},
          {-r, y, 0}, {-r, y, k}, {-k, y, r}, {0, y, r},  {k, y, r},   {r, y, k}};
}

Loop loop_of(const HalfLoop& half) {
  const auto& p = half.points;
  const double z = half.z;
  return {{p[0], 0}, {p[1], z}, {p[2], z}, {p[3], 0}, {p[2], -z}, {p[1], -z}};
}

dvec3 bezier(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d, double t) {
  const double s = 1.0 - t;
  return s * s * s * a + 3.0 * s * s * t * b + 3.0 * s * t * t * c + t * t * t * d;
}

/// The point of a control loop at parameter t of its curve number `curve`.
dvec3 point_on(const Loop& loop, std::size_t curve, double t) {
  const auto at = [&](std::size_t i) { return loop[(3 * curve + i) % loop.size()]; };
  return bezier(at(0), at(1), at(2), at(3), t);
}

/// The surface of patches on a stack of control loops as rings, `segments` a patch.
template <class Row>
std::vector<Ring> tessellate(std::span<const Row> rows, int segments) {
  std::vector<Ring> stack;  // the control loops at the parameters of the rings' points
  for (const Row& row : rows) {
    const Loop loop = loop_of(row);
    Ring& ring = stack.emplace_back();
    for (std::size_t curve = 0; curve < loop.size() / 3; ++curve) {
      for (int i = 0; i < segments; ++i) {
        ring.push_back(point_on(loop, curve, static_cast<double>(i) / segments));
      }
    }
  }
  std::vector<Ring> rings;
  for (std::size_t patch = 0; patch + 3 < stack.size(); patch += 3) {
    const int last = patch + 6 < stack.size() ? segments - 1 : segments;
    for (int i = 0; i <= last; ++i) {
      Ring& ring = rings.emplace_back();
      for (std::size_t k = 0; k < stack[0].size(); ++k) {
        ring.push_back(bezier(stack[patch][k], stack[patch + 1][k], stack[patch + 2][k],
                              stack[patch + 3][k], static_cast<double>(i) / segments));
      }
    }
  }
  return rings;
}

}  // namespace

Mesh make_teapot(int segments) {
  assert(segments >= 1);
  Mesh mesh;
  std::vector<Ring> body = tessellate(std::span<const Circle>(pot), segments);
  const std::vector<Ring> top = tessellate(std::span<const Circle>(lid), segments);
  body.insert(body.end(), top.begin(), top.end());
  append_rings(mesh, body);
  append_rings(mesh, tessellate(std::span<const HalfLoop>(handle), segments));
  append_rings(mesh, tessellate(std::span<const HalfLoop>(spout), segments));
  set_smooth_normals(mesh, 50.0);
  return mesh;
}

}  // namespace collage
