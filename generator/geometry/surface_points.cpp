#include "geometry/surface_points.h"

#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "geometry/box_tree.h"
#include "geometry/boxes.h"

namespace collage {
namespace {

/// The triangles in the order of a hierarchy's leaves, which keeps neighbours together.
std::vector<std::uint32_t> row_of_triangles(const Mesh& mesh) {
  std::vector<std::uint32_t> row;
  const BoxTree tree(boxes_of_triangles(mesh));
  for (const BoxTree::Node& node : tree.nodes()) {
    if (node.is_leaf()) {
      row.push_back(node.item);
    }
  }
  return row;
}

/// Twice the area, along the normal.
dvec3 area_vector(const Mesh& mesh, std::uint32_t triangle) {
  const dvec3 a = mesh.corner(triangle, 0);
  return glm::cross(mesh.corner(triangle, 1) - a, mesh.corner(triangle, 2) - a);
}

/// Points one after the other fill a triangle evenly: the R2 sequence (Roberts 2018, "The
/// unreasonable effectiveness of quasirandom sequences") in the unit square, which Osada,
/// Funkhouser, Chazelle and Dobkin 2002 ("Shape distributions", eq. 1) map to the triangle.
dvec3 point_of_sequence(const Mesh& mesh, std::uint32_t triangle, std::size_t i) {
  constexpr double plastic = 1.32471795724474602596;
  const auto n = static_cast<double>(i);
  const double root = std::sqrt(glm::fract(n / plastic));
  const double across = glm::fract(n / (plastic * plastic));
  return (1.0 - root) * mesh.corner(triangle, 0) +
         root * (1.0 - across) * mesh.corner(triangle, 1) +
         root * across * mesh.corner(triangle, 2);
}

}  // namespace

std::vector<SurfacePoint> spread_over_surface(const Mesh& mesh, std::size_t count) {
  const std::vector<std::uint32_t> row = row_of_triangles(mesh);
  std::vector<double> area_up_to;
  area_up_to.reserve(row.size());
  double sum = 0.0;
  for (const std::uint32_t triangle : row) {
    sum += glm::length(area_vector(mesh, triangle));
    area_up_to.push_back(sum);
  }
  std::vector<SurfacePoint> points;
  for (std::size_t i = 0; sum > 0.0 && i < count; ++i) {
    Rng rng(0, i);
    const double at = (static_cast<double>(i) + rng.uniform()) / static_cast<double>(count) * sum;
    // `at` rounds to `sum` at most, whose triangle is the last that has an area.
    const auto place = std::lower_bound(area_up_to.begin(), area_up_to.end(), at);
    const std::uint32_t triangle = row[static_cast<std::size_t>(place - area_up_to.begin())];
    points.push_back(
        {point_of_sequence(mesh, triangle, i), glm::normalize(area_vector(mesh, triangle))});
  }
  return points;
}

}  // namespace collage
