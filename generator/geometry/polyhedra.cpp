#include "geometry/polyhedra.h"

#include <cmath>
#include <numbers>

namespace collage {
namespace {

PolygonMesh polyhedron(std::vector<dvec3> corners) {
  for (dvec3& corner : corners) {
    corner = glm::normalize(corner);
  }
  return convex_polyhedron(std::move(corners));
}

std::vector<dvec3> cube_corners() {
  std::vector<dvec3> corners;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double z : {-1.0, 1.0}) {
        corners.emplace_back(x, y, z);
      }
    }
  }
  return corners;
}

}  // namespace

PolygonMesh regular_tetrahedron() {
  return polyhedron({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}});
}

PolygonMesh regular_cube() { return polyhedron(cube_corners()); }

PolygonMesh regular_octahedron() {
  return polyhedron({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
}

PolygonMesh regular_dodecahedron() {
  constexpr double phi = std::numbers::phi;
  std::vector<dvec3> corners = cube_corners();
  for (const double a : {-1.0 / phi, 1.0 / phi}) {
    for (const double b : {-phi, phi}) {
      corners.insert(corners.end(), {{0.0, a, b}, {a, b, 0.0}, {b, 0.0, a}});
    }
  }
  return polyhedron(corners);
}

PolygonMesh regular_prism(int corners, double stretch) {
  std::vector<dvec3> points;
  const double step = 2.0 * std::numbers::pi / corners;
  for (const double y : {-1.0, 1.0}) {
    for (int i = 0; i < corners; ++i) {
      points.emplace_back(std::cos(i * step), y * stretch * std::sin(0.5 * step),
                          std::sin(i * step));
    }
  }
  return polyhedron(points);
}

}  // namespace collage
