#include "geometry/closest_point.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace collage {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// The slow twin: every triangle, in double.
double brute_force_distance(const Mesh& mesh, const dvec3& query) {
  double best = unbounded;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const dvec3 point =
        closest_point_on_triangle(query, mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
    best = std::min(best, glm::distance(query, point));
  }
  return best;
}

TEST(ClosestPointOnTriangle, CoversCornersEdgesAndFace) {
  const dvec3 a(0, 0, 0);
  const dvec3 b(1, 0, 0);
  const dvec3 c(0, 1, 0);
  EXPECT_EQ(closest_point_on_triangle({-1, -1, 3}, a, b, c), a);
  EXPECT_EQ(closest_point_on_triangle({2, -1, 3}, a, b, c), b);
  EXPECT_EQ(closest_point_on_triangle({-1, 2, 3}, a, b, c), c);
  EXPECT_EQ(closest_point_on_triangle({0.5, -1, 0}, a, b, c), dvec3(0.5, 0, 0));
  EXPECT_EQ(closest_point_on_triangle({-1, 0.5, 0}, a, b, c), dvec3(0, 0.5, 0));
  EXPECT_EQ(closest_point_on_triangle({1, 1, 0}, a, b, c), dvec3(0.5, 0.5, 0));
  EXPECT_EQ(closest_point_on_triangle({0.25, 0.25, -7}, a, b, c), dvec3(0.25, 0.25, 0));
}

TEST(ClosestPointIndex, NeverFarFromBruteForceAndNeverNearer) {
  const Mesh mesh = test::blob_mesh(0.7, 0.3, 20);
  const ClosestPointIndex index(mesh);
  Rng rng(7, 0);
  for (int i = 0; i < 2000; ++i) {
    const dvec3 query = test::random_point(rng, 3.0);
    const double truth = brute_force_distance(mesh, query);
    const auto found = index.find(query, unbounded);
    ASSERT_TRUE(found);
    EXPECT_LE(truth, found->distance * (1.0 + 1e-14));
    EXPECT_LE(found->distance - ClosestPointIndex::error(query), truth);
    EXPECT_NEAR(glm::distance(query, found->point), found->distance, 1e-12);
  }
}

/// Wherever the search begins, and also among slivers, triangles without area and large flat faces.
/// Stacks of triangles much taller than wide, and ones whose angles are lost in double.
TEST(ClosestPointIndex, OfTinyTrianglesIsNeverTooFar) {
  struct Stack {
    double size;
    double height;
  };
  for (const auto& [size, height] : {Stack{1e-6, 1.0},
                                     {1e-10, 1.0},
                                     {1e-13, 1.0},
                                     {1e-79, 1e-79},
                                     {1e-80, 1e-80},
                                     {1e-81, 1e-81},
                                     {1e-160, 1e-160}}) {
    Mesh mesh;
    Rng rng(5, 6);
    for (std::uint32_t t = 0; t < 64; ++t) {
      const dvec3 at = glm::normalize(dvec3(0.3, 0.5, 0.8)) * (height * t / 64.0);
      for (int k = 0; k < 3; ++k) {
        dvec3 corner(0.1 * rng.uniform());
        corner[k] += 1.0;  // so that all face much the same way
        mesh.positions.push_back(at + size * corner);
      }
      mesh.triangles.push_back(3 * t + uvec3(0, 1, 2));
    }
    const ClosestPointIndex index(mesh);
    for (int i = 0; i < 200; ++i) {
      const dvec3 query(rng.uniform(), rng.uniform(), rng.uniform());
      const double least = brute_force_distance(mesh, query);
      const auto found = index.find(query, (1.0 + 1e-12) * least);
      ASSERT_TRUE(found) << size;
      EXPECT_EQ(found->distance, least) << size;
    }
  }
}

TEST(ClosestPointIndex, HintsChangeNothing) {
  Mesh slivers = test::box_mesh(dvec3(-0.5), dvec3(0.5));
  Rng rng(9, 0);
  for (int i = 0; i < 200; ++i) {
    const dvec3 corner = test::random_point(rng, 0.5);
    const dvec3 along = test::random_point(rng, 0.3);
    const dvec3 aside = i % 4 == 0 ? dvec3(0.0) : test::random_point(rng, 1e-8);
    const auto first = static_cast<std::uint32_t>(slivers.positions.size());
    slivers.positions.insert(slivers.positions.end(),
                             {corner, corner + along, corner + 0.5 * along + aside});
    slivers.triangles.emplace_back(first, first + 1, first + 2);
  }
  for (const Mesh& mesh : {test::blob_mesh(0.7, 0.3, 20), slivers}) {
    const ClosestPointIndex index(mesh);
    for (int i = 0; i < 1000; ++i) {
      const dvec3 query = test::random_point(rng, i % 2 == 0 ? 0.8 : 5.0);
      const auto plain = index.find(query, unbounded);
      ASSERT_LE(plain->distance, brute_force_distance(mesh, query) * (1.0 + 1e-12));
      for (int k = 0; k < 4; ++k) {
        const auto hint = static_cast<std::uint32_t>(rng.below(mesh.triangles.size()));
        const auto hinted = index.find(query, k == 0 ? plain->distance * 1.0001 : unbounded, hint);
        ASSERT_TRUE(hinted);
        ASSERT_EQ(hinted->distance, plain->distance);
        ASSERT_EQ(hinted->triangle, plain->triangle);
      }
      ASSERT_FALSE(index.find(query, plain->distance, plain->triangle));
    }
  }
}

/// Which one the hierarchy comes to first depends on the processor's vector instructions.
TEST(ClosestPointIndex, OfThoseAsNearTakesTheFirst) {
  Mesh cube = test::box_mesh(dvec3(-0.5), dvec3(0.5));
  const auto nearest = ClosestPointIndex(cube).find(dvec3(0.0), 2.0);
  EXPECT_EQ(nearest->triangle, 0U);
  std::ranges::reverse(cube.triangles);
  const auto of_reversed = ClosestPointIndex(cube).find(dvec3(0.0), 2.0);
  EXPECT_EQ(of_reversed->triangle, 0U);
  EXPECT_EQ(of_reversed->distance, 0.5);
  EXPECT_NE(of_reversed->point, nearest->point);
}

TEST(ClosestPointIndex, FindsNothingBeyondTheGivenDistance) {
  const ClosestPointIndex index(test::box_mesh(dvec3(-0.5), dvec3(0.5)));
  EXPECT_FALSE(index.find({0, 0, 0}, 0.5));
  EXPECT_FALSE(index.find({0.9, 0, 0}, 0.3999));
  const auto found = index.find({0.9, 0, 0}, 0.4001);
  ASSERT_TRUE(found);
  EXPECT_DOUBLE_EQ(found->distance, 0.4);
}

TEST(ClosestPointIndex, EndsWithAnyPointThatIsNearEnough) {
  const Mesh mesh = test::blob_mesh(0.7, 0.3, 20);
  const ClosestPointIndex index(mesh);
  Rng rng(8, 0);
  int farther = 0;
  for (int i = 0; i < 2000; ++i) {
    const dvec3 query = test::random_point(rng, 2.0);
    const double nearest = index.find(query, unbounded)->distance;
    const double near_enough = nearest * (0.5 + rng.uniform());
    const double limit = nearest * (0.5 + rng.uniform());
    const auto found = index.find(query, unbounded, std::nullopt, near_enough);
    if (nearest < near_enough) {
      ASSERT_LT(found->distance, near_enough);
      farther += found->distance > nearest ? 1 : 0;
    } else {
      ASSERT_EQ(found->distance, nearest);
    }
    ASSERT_EQ(index.find(query, limit, std::nullopt, near_enough).has_value(), nearest < limit);
  }
  EXPECT_GT(farther, 100);
}

TEST(ClosestPointIndex, VerticesAloneAreNeverNearerThanTriangles) {
  const Mesh mesh = test::torus_mesh(0.6, 0.2, 24, 12);
  const ClosestPointIndex triangles(mesh);
  const ClosestPointIndex vertices(mesh, ClosestPointIndex::Surface::vertices);
  Rng rng(8, 0);
  for (int i = 0; i < 500; ++i) {
    const dvec3 query = test::random_point(rng, 1.5);
    double truth = unbounded;
    for (const dvec3& position : mesh.positions) {
      truth = std::min(truth, glm::distance(query, position));
    }
    const auto found = vertices.find(query, unbounded);
    EXPECT_NEAR(found->distance, truth, ClosestPointIndex::error(query));
    EXPECT_GE(found->distance, triangles.find(query, unbounded)->distance - 1e-12);
  }
}

}  // namespace
}  // namespace collage
