#include "geometry/triangle_distance.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "geometry/closest_point.h"
#include "support/meshes.h"

namespace collage {
namespace {

/// The slow twin: the distance from a point of s to t is convex over s, so that a search that
/// narrows down by thirds along both directions of s finds the least.
template <class Function>
double least_on_unit_interval(const Function& f) {
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 90; ++i) {
    const double third = (high - low) / 3.0;
    if (f(low + third) > f(high - third)) {
      low += third;
    } else {
      high -= third;
    }
  }
  return std::min({f(0.0), f(0.5 * (low + high)), f(1.0)});
}

double distance_by_search(const Corners& s, const Corners& t) {
  return least_on_unit_interval([&](double u) {
    return least_on_unit_interval([&](double v) {
      const dvec3 point = glm::mix(s[0], glm::mix(s[1], s[2], v), u);
      return glm::distance(point, closest_point_on_triangle(point, t[0], t[1], t[2]));
    });
  });
}

Corners random_triangle(Rng& rng, const dvec3& at) {
  return {at + test::random_point(rng, 1.0), at + test::random_point(rng, 1.0),
          at + test::random_point(rng, 1.0)};
}

TEST(TriangleDistance, AgreesWithASearch) {
  Rng rng(51, 0);
  int apart = 0;
  for (int i = 0; i < 300; ++i) {
    const Corners s = random_triangle(rng, dvec3(0));
    const Corners t = random_triangle(rng, test::random_point(rng, 0.7));
    const double distance = triangle_distance(s, t);
    EXPECT_NEAR(distance, distance_by_search(s, t), 1e-7);
    EXPECT_NEAR(distance, triangle_distance(t, s), 1e-14);
    apart += distance > 0.0 ? 1 : 0;
  }
  EXPECT_GT(apart, 100);
  EXPECT_LT(apart, 280);
}

TEST(TriangleDistance, OfTrianglesInKnownPlaces) {
  const Corners s{dvec3(0, 0, 0), dvec3(1, 0, 0), dvec3(0, 1, 0)};
  const auto moved = [&](const dvec3& by) { return Corners{s[0] + by, s[1] + by, s[2] + by}; };
  EXPECT_EQ(triangle_distance(s, s), 0.0);
  EXPECT_EQ(triangle_distance(s, moved({0.1, 0.1, 0})), 0.0);  // in one plane
  EXPECT_EQ(triangle_distance(s, moved({0, 0, 3})), 3.0);
  EXPECT_EQ(triangle_distance(s, moved({1, 0, 0})), 0.0);  // a corner in common
  EXPECT_EQ(triangle_distance(s, moved({3, 0, 0})), 2.0);  // in line
  EXPECT_DOUBLE_EQ(triangle_distance(s, moved({2, 0, 2})), std::sqrt(5.0));
  // Edges that cross at a distance, corners far away.
  const Corners above{dvec3(0.5, -9, 1), dvec3(0.5, 9, 1), dvec3(0.5, 0, 9)};
  EXPECT_DOUBLE_EQ(triangle_distance({dvec3(-9, 0, 0), dvec3(9, 0, 0), dvec3(0, 0, -9)}, above),
                   1.0);
  // An edge goes through the other's face, its ends far away.
  EXPECT_EQ(triangle_distance(s, {dvec3(0.2, 0.2, -9), dvec3(0.2, 0.2, 9), dvec3(9, 9, 9)}), 0.0);
}

TEST(TriangleDistance, TakesSegmentsAndPoints) {
  const Corners s{dvec3(0, 0, 0), dvec3(1, 0, 0), dvec3(0, 1, 0)};
  const Corners point{dvec3(0.2, 0.2, 2), dvec3(0.2, 0.2, 2), dvec3(0.2, 0.2, 2)};
  const Corners segment{dvec3(-3, 0.5, 4), dvec3(0, 0.5, 4), dvec3(3, 0.5, 4)};
  EXPECT_DOUBLE_EQ(triangle_distance(s, point), 2.0);
  EXPECT_DOUBLE_EQ(triangle_distance(point, s), 2.0);
  EXPECT_DOUBLE_EQ(triangle_distance(s, segment), 4.0);
  EXPECT_DOUBLE_EQ(triangle_distance(segment, s), 4.0);
  EXPECT_NEAR(triangle_distance(point, segment), std::sqrt(4.09), 1e-15);
  EXPECT_EQ(triangle_distance(segment, segment), 0.0);
}

TEST(SquaredSegmentDistance, OfParallelAndTouchingSegments) {
  EXPECT_EQ(squared_segment_distance({0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {1, 2, 0}), 4.0);
  EXPECT_EQ(squared_segment_distance({0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {2, 0, 0}), 1.0);
  EXPECT_EQ(squared_segment_distance({0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 1}), 0.0);
  EXPECT_EQ(squared_segment_distance({0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}), 1.0);
}

}  // namespace
}  // namespace collage
