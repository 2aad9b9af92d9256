#include "geometry/surface_points.h"

#include <array>

#include <gtest/gtest.h>

#include "geometry/closest_point.h"
#include "support/meshes.h"

namespace collage {
namespace {

TEST(SpreadOverSurface, GivesEachFaceItsShare) {
  // Faces of 6, 3 and 2 twice each, in boxes with triangles of very different sizes.
  const Mesh mesh = test::box_mesh(dvec3(0), dvec3(1, 2, 3));
  const auto points = spread_over_surface(mesh, 22000);
  ASSERT_EQ(points.size(), 22000U);
  std::array<int, 3> on_face{};
  for (const auto& [position, normal] : points) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      on_face[axis] += normal[static_cast<int>(axis)] != 0.0 ? 1 : 0;
    }
  }
  EXPECT_NEAR(on_face[0], 12000, 8);  // exact but for the pieces that a triangle's end cuts
  EXPECT_NEAR(on_face[1], 6000, 8);
  EXPECT_NEAR(on_face[2], 4000, 8);
}

TEST(SpreadOverSurface, PutsPointsOnTheTrianglesWithNormalsOutward) {
  const Mesh ball = test::blob_mesh(1.0, 0.0, 30);
  const ClosestPointIndex index(ball);
  for (const auto& [position, normal] : spread_over_surface(ball, 500)) {
    EXPECT_LT(index.find(position, 2.0)->distance, 1e-15);
    EXPECT_GT(glm::dot(position, normal), 0.99);
  }
}

/// The largest difference between the share of points and of area in caps of a ball.
double discrepancy(const std::vector<SurfacePoint>& points) {
  Rng rng(31, 0);
  double largest = 0.0;
  for (int i = 0; i < 300; ++i) {
    const dvec3 axis = glm::normalize(test::random_point(rng, 1.0));
    const double height = 2.0 * rng.uniform() - 1.0;
    double share = 0.0;
    for (const auto& [position, normal] : points) {
      share += glm::dot(position, axis) > height ? 1.0 / static_cast<double>(points.size()) : 0.0;
    }
    largest = std::max(largest, std::abs(share - 0.5 * (1.0 - height)));
  }
  return largest;
}

TEST(SpreadOverSurface, IsMuchMoreEvenThanPointsAtRandom) {
  const Mesh ball = test::blob_mesh(1.0, 0.0, 60);
  std::vector<SurfacePoint> random;
  Rng rng(32, 0);
  while (random.size() < 2000) {
    const dvec3 point = test::random_point(rng, 1.0);
    if (glm::length(point) < 1.0 && glm::length(point) > 0.0) {
      random.push_back({glm::normalize(point), glm::normalize(point)});
    }
  }
  EXPECT_LT(discrepancy(spread_over_surface(ball, 2000)), 0.4 * discrepancy(random));
}

TEST(SpreadOverSurface, IsMuchMoreEvenThanPointsAtRandomWithinLargeTriangles) {
  // Shares of a quarter of each face, from 6000 points: at random they deviate by 0.0056.
  const auto points = spread_over_surface(test::box_mesh(dvec3(-1), dvec3(1)), 6000);
  for (const dvec3& at : {dvec3(0), dvec3(-0.5), dvec3(0.3, -0.7, 0.1)}) {
    double share = 0.0;
    for (const auto& [position, normal] : points) {
      const dvec3 away = glm::abs(position - at) * (1.0 - glm::abs(normal));
      share += glm::all(glm::lessThan(away, dvec3(0.5))) ? 1.0 / 6000.0 : 0.0;
    }
    EXPECT_NEAR(share, at.y == -0.7 ? 0.65 / 3.0 : 0.25, 0.003);
  }
}

TEST(SpreadOverSurface, PassesOverTrianglesWithoutArea) {
  Mesh mesh = test::box_mesh(dvec3(0), dvec3(1));
  mesh.triangles.emplace_back(3, 3, 3);
  mesh.triangles.insert(mesh.triangles.begin(), uvec3(0, 1, 1));
  for (const auto& [position, normal] : spread_over_surface(mesh, 1000)) {
    EXPECT_NEAR(glm::length(normal), 1.0, 1e-15);
  }
  mesh.triangles = {{0, 1, 1}};
  EXPECT_TRUE(spread_over_surface(mesh, 10).empty());
  EXPECT_TRUE(spread_over_surface(Mesh{}, 10).empty());
}

}  // namespace
}  // namespace collage
