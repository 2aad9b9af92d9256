#include "geometry/polygon.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "base/rng.h"

namespace collage {
namespace {

using Points = std::vector<dvec3>;

/// The polygon's area vector, and for a triangulation its sum and the sum of the lengths: equal
/// where no triangle is turned over, that is, where none overlaps another.
dvec3 area_of(const Points& p) {
  dvec3 sum(0.0);
  for (std::size_t i = 0; i < p.size(); ++i) {
    sum += 0.5 * glm::cross(p[i] - p[0], p[(i + 1) % p.size()] - p[0]);
  }
  return sum;
}

void expect_covers(const Points& p, double area) {
  const auto triangles = triangulate(p);
  ASSERT_EQ(triangles.size(), p.size() - 2);
  dvec3 sum(0.0);
  double lengths = 0.0;
  for (const auto& [a, b, c] : triangles) {
    const dvec3 own = 0.5 * glm::cross(p[b] - p[a], p[c] - p[a]);
    sum += own;
    lengths += glm::length(own);
  }
  EXPECT_NEAR(glm::distance(sum, area_of(p)), 0.0, 1e-12 * area);
  EXPECT_NEAR(lengths, area, 1e-12 * area);
}

Points star(int spikes) {
  Points points;
  for (int i = 0; i < 2 * spikes; ++i) {
    const double angle = std::numbers::pi * i / spikes;
    const double radius = i % 2 == 0 ? 1.0 : 0.3;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
  }
  return points;
}

TEST(Polygon, ConcaveQuadIsCutAtItsReflexCorner) {
  for (std::size_t start = 0; start < 4; ++start) {
    Points dart = {{0, 0, 0}, {4, 1, 0}, {0, 2, 0}, {1, 1, 0}};
    std::rotate(dart.begin(), dart.begin() + static_cast<std::ptrdiff_t>(start), dart.end());
    expect_covers(dart, 3.0);
  }
}

TEST(Polygon, ConvexQuadIsCutAlongTheShorterDiagonal) {
  const Points kite = {{0, 0, 0}, {1, -1, 0}, {5, 0, 0}, {1, 1, 0}};
  for (const auto& triangle : triangulate(kite)) {
    EXPECT_EQ(std::count(triangle.begin(), triangle.end(), 1), 1);
    EXPECT_EQ(std::count(triangle.begin(), triangle.end(), 3), 1);
  }
}

TEST(Polygon, LAndStarAreCoveredInAnyPlaneAndFromAnyCorner) {
  Rng rng(1, 1);
  for (int i = 0; i < 50; ++i) {
    const auto random = [&] { return 2.0 * rng.uniform() - 1.0; };
    const dvec3 u = glm::normalize(dvec3(random(), random(), random()));
    const dvec3 v = glm::normalize(glm::cross(u, dvec3(random(), random(), random())));
    for (auto [points, area] :
         {std::pair{Points{{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}}, 5.0},
          std::pair{star(7), 7 * 0.3 * std::sin(std::numbers::pi / 7)}}) {
      for (dvec3& p : points) {
        p = dvec3(10, 20, 30) + p.x * u + p.y * v;
      }
      std::rotate(points.begin(), points.begin() + i % 6, points.end());
      expect_covers(points, area);
    }
  }
}

TEST(Polygon, CollinearCornersStayInUse) {
  const Points square = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}};
  expect_covers(square, 4.0);
  for (const auto& [a, b, c] : triangulate(square)) {
    EXPECT_GT(glm::cross(square[b] - square[a], square[c] - square[a]).z, 0.0);
  }
}

TEST(Polygon, BridgeToAHoleIsNoObstacle) {
  const Points ring = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                       {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
  expect_covers(ring, 12.0);
}

TEST(Polygon, NonplanarPolygonKeepsItsRimAndAreaVector) {
  Points rim = star(5);
  for (std::size_t i = 0; i < rim.size(); ++i) {
    rim[i].z = 0.1 * std::sin(static_cast<double>(3 * i));
  }
  const auto triangles = triangulate(rim);
  dvec3 sum(0.0);
  for (const auto& [a, b, c] : triangles) {
    const dvec3 own = 0.5 * glm::cross(rim[b] - rim[a], rim[c] - rim[a]);
    EXPECT_GT(own.z, 0.0);
    sum += own;
  }
  EXPECT_EQ(triangles.size(), rim.size() - 2);
  EXPECT_NEAR(glm::distance(sum, area_of(rim)), 0.0, 1e-14);
}

TEST(Polygon, WhatIsNoPolygonStillEnds) {
  EXPECT_TRUE(triangulate(Points{{0, 0, 0}, {1, 0, 0}}).empty());
  EXPECT_EQ(triangulate(Points(6, dvec3(1.0))).size(), 4U);
  const Points bow_tie = {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(triangulate(bow_tie).size(), 2U);
  const Points line = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5, 0, 0}};
  EXPECT_EQ(triangulate(line).size(), 3U);
  Rng rng(2, 2);
  Points tangle;
  for (int i = 0; i < 200; ++i) {
    tangle.emplace_back(rng.uniform(), rng.uniform(), rng.uniform());
  }
  EXPECT_EQ(triangulate(tangle).size(), 198U);
}

}  // namespace
}  // namespace collage
