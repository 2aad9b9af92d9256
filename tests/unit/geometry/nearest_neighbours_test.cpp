#include "geometry/nearest_neighbours.h"

#include <limits>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace collage {
namespace {

/// The slow twin.
std::vector<std::uint32_t> by_brute_force(const std::vector<dvec3>& points) {
  std::vector<std::uint32_t> nearest(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    double best = std::numeric_limits<double>::infinity();
    for (std::uint32_t j = 0; j < points.size(); ++j) {
      const dvec3 d = points[i] - points[j];
      if (j != i && glm::dot(d, d) < best) {
        best = glm::dot(d, d);
        nearest[i] = j;
      }
    }
  }
  return nearest;
}

TEST(NearestNeighbours, AgreeWithBruteForce) {
  for (const std::size_t count : {2U, 3U, 10U, 500U}) {
    Rng rng(41, count);
    std::vector<dvec3> points;
    for (std::size_t i = 0; i < count; ++i) {
      points.push_back(test::random_point(rng, 1.0));
    }
    EXPECT_EQ(nearest_neighbours(points), by_brute_force(points));
  }
}

TEST(NearestNeighbours, AreTheFirstOfThoseEquallyNear) {
  std::vector<dvec3> points;
  for (int i = 0; i < 125; ++i) {
    points.emplace_back(i % 5, i / 5 % 5, i / 25);  // a lattice, with six at distance 1
  }
  points.insert(points.end(), 3, points[62]);  // and some at one place
  EXPECT_EQ(nearest_neighbours(points), by_brute_force(points));
}

}  // namespace
}  // namespace collage
