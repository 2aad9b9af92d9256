#include "geometry/distance_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace collage {
namespace {

constexpr DistanceBounds::Detail details[] = {DistanceBounds::Detail::fine,
                                              DistanceBounds::Detail::coarse};

/// The slow twin: every triangle, in double.
double brute_force_distance(const Mesh& mesh, const dvec3& query) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const dvec3 point =
        closest_point_on_triangle(query, mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
    best = std::min(best, glm::distance(query, point));
  }
  return best;
}

struct Case {
  const char* name;
  Mesh mesh;
};

/// Smooth, with edges, open, with a medial axis through the middle, and one triangle alone.
std::vector<Case> cases() {
  Mesh triangle;
  triangle.positions = {{-1, 0, 0}, {1, 0, 0}, {0, 0.5, 0}};
  triangle.triangles = {{0, 1, 2}};
  return {{"ring", test::torus_mesh(0.75, 0.25, 24, 12)},
          {"box", test::box_mesh(dvec3(-0.57), dvec3(0.57))},
          {"open box", test::open_box_mesh(dvec3(-0.3, -0.6, -0.5), dvec3(0.3, 0.6, 0.5))},
          {"blob", test::blob_mesh(0.7, 0.3, 12)},
          {"triangle", triangle}};
}

TEST(DistanceBounds, HoldTheDistanceByBruteForce) {
  for (const auto& [name, mesh] : cases()) {
    const ClosestPointIndex index(mesh);
    const std::array bounds{DistanceBounds(index),
                            DistanceBounds(index, DistanceBounds::Detail::coarse)};
    Rng rng(3, 1);
    for (const double half_side : {1.0, 2.0, 15.9}) {
      for (int i = 0; i < 1500; ++i) {
        const glm::vec3 query(test::random_point(rng, half_side));
        const double distance = brute_force_distance(mesh, dvec3(query));
        for (const auto detail : details) {
          for (const DistanceBounds& each : bounds) {
            const auto [lower, gap] = each.squared(query, detail);
            ASSERT_LE(lower, distance * distance) << name;
            ASSERT_GE(static_cast<double>(lower) + gap, distance * distance) << name;
          }
        }
      }
    }
  }
}

/// Also at the nodes, on the faces between cells and where one grid ends and the next begins.
TEST(DistanceBounds, HoldOnTheGridsOwnPlanes) {
  const Mesh mesh = test::blob_mesh(0.7, 0.3, 8);
  const DistanceBounds bounds{ClosestPointIndex(mesh)};
  for (const float x : {-8.0F, -1.0F, -0.25F, 0.0F, 0.5F, 1.0F, 2.0F, 4.0F, 15.0F}) {
    for (const float y : {-1.0F, 0.0F, 0.0625F, 0.99999994F}) {
      for (const float z : {-2.0F, 0.0F, 0.1F, 0.99999994F, 1.0F}) {
        const double distance = brute_force_distance(mesh, {x, y, z});
        for (const auto detail : details) {
          const auto [lower, gap] = bounds.squared({x, y, z}, detail);
          ASSERT_LE(lower, distance * distance);
          ASSERT_GE(static_cast<double>(lower) + gap, distance * distance);
        }
      }
    }
  }
}

/// Four at once against one by one, in grids of their own each.
TEST(DistanceBounds, OfFourAreThoseOfEach) {
  const DistanceBounds bounds{ClosestPointIndex(test::blob_mesh(0.7, 0.3, 8))};
  Rng rng(9, 1);
  for (int i = 0; i < 4000; ++i) {
    Points<Four> queries;
    for (std::size_t lane = 0; lane < four_lanes; ++lane) {
      set_lane(queries, lane, test::random_point(rng, std::ldexp(0.99, rng.below(5))));
    }
    if (i % 8 == 0) {
      queries[2][0] = 0.99999994F;  // the cell after the last, by rounding
    }
    for (const auto detail : details) {
      const auto [lower, gap] = bounds.squared(queries, detail);
      for (std::size_t lane = 0; lane < four_lanes; ++lane) {
        const auto one =
            bounds.squared({queries[0][lane], queries[1][lane], queries[2][lane]}, detail);
        ASSERT_EQ(lower[lane], one.lower);
        ASSERT_EQ(gap[lane], one.gap);
      }
    }
  }
}

/// Bounds that are true but say nothing would not be worth their memory.
TEST(DistanceBounds, AreTightAndTighterWhereFine) {
  const DistanceBounds bounds{ClosestPointIndex(test::torus_mesh(0.75, 0.25, 24, 12))};
  Rng rng(4, 1);
  double fine = 0.0;
  double coarse = 0.0;
  constexpr int queries = 2000;
  for (int i = 0; i < queries; ++i) {
    const glm::vec3 query(test::random_point(rng, 1.0));
    fine += bounds.squared(query, DistanceBounds::Detail::fine).gap;
    coarse += bounds.squared(query, DistanceBounds::Detail::coarse).gap;
  }
  EXPECT_LT(fine / queries, 0.03);
  EXPECT_LT(fine, 0.6 * coarse);
}

TEST(DistanceBounds, HintsAtTrianglesThatAreNear) {
  const Mesh mesh = test::blob_mesh(0.7, 0.3, 20);
  const DistanceBounds bounds{ClosestPointIndex(mesh)};
  Rng rng(5, 1);
  for (int i = 0; i < 2000; ++i) {
    const bool near = i % 2 == 0;
    const dvec3 query = test::random_point(rng, near ? 1.0 : 20.0);
    const std::uint32_t hint = bounds.hint(query);
    ASSERT_LT(hint, mesh.triangles.size());
    const dvec3 point = closest_point_on_triangle(query, mesh.corner(hint, 0), mesh.corner(hint, 1),
                                                  mesh.corner(hint, 2));
    const double distance = brute_force_distance(mesh, query);
    // The node is at most half a cell's diagonal away: once there, once back. Far out any will do.
    const double slack = near ? std::sqrt(3.0) * 2.0 / 32.0 : 2.0;
    EXPECT_LE(glm::distance(query, point), distance + slack);
  }
}

}  // namespace
}  // namespace collage
