#include "geometry/triangle_intersection.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "base/rng.h"
#include "geometry/closest_point.h"

namespace collage {
namespace {

const Corners flat{dvec3(0, 0, 0), dvec3(4, 0, 0), dvec3(0, 4, 0)};

/// In every order of corners and of triangles.
void expect_everywhere(bool wanted, Corners s, Corners t) {
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      EXPECT_EQ(triangles_intersect(s, t), wanted);
      EXPECT_EQ(triangles_intersect(t, s), wanted);
      std::next_permutation(t.begin(), t.end(), [](const dvec3& a, const dvec3& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
      });
    }
    std::next_permutation(s.begin(), s.end(), [](const dvec3& a, const dvec3& b) {
      return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    });
  }
}

TEST(TrianglesIntersect, WhereTheyCross) {
  expect_everywhere(true, flat, {dvec3(1, 1, -1), dvec3(1, 1, 1), dvec3(2, 2, 1)});
  expect_everywhere(true, flat, {dvec3(-1, 1, -1), dvec3(5, 1, -1), dvec3(1, 1, 3)});
}

TEST(TrianglesIntersect, NotWherePlanesCrossElsewhere) {
  expect_everywhere(false, flat, {dvec3(5, 5, -1), dvec3(5, 5, 1), dvec3(6, 6, 1)});
  expect_everywhere(false, flat, {dvec3(1, 1, 1), dvec3(2, 1, 1), dvec3(1, 2, 2)});
}

TEST(TrianglesIntersect, WhereTheyTouch) {
  expect_everywhere(true, flat, {dvec3(1, 1, 0), dvec3(1, 1, 1), dvec3(2, 2, 1)});    // in the face
  expect_everywhere(true, flat, {dvec3(2, 0, 0), dvec3(2, -1, 1), dvec3(3, -1, 1)});  // on an edge
  expect_everywhere(true, flat, {dvec3(0, 0, 0), dvec3(-1, 0, 1), dvec3(0, -1, 1)});  // at a corner
  expect_everywhere(true, flat, {dvec3(1, 0, 0), dvec3(3, 0, 0), dvec3(2, -1, 1)});   // along edges
  expect_everywhere(false, flat, {dvec3(2, -1e-300, 0), dvec3(2, -1, 1), dvec3(3, -1, 1)});
}

TEST(TrianglesIntersect, InOnePlane) {
  expect_everywhere(true, flat, {dvec3(1, 1, 0), dvec3(1.5, 1, 0), dvec3(1, 1.5, 0)});  // within
  expect_everywhere(true, flat, {dvec3(-1, 1, 0), dvec3(5, 1, 0), dvec3(-1, 1.5, 0)});  // across
  expect_everywhere(true, flat, {dvec3(4, 0, 0), dvec3(5, 0, 0), dvec3(5, 1, 0)});      // corners
  expect_everywhere(false, flat, {dvec3(4, 4, 0), dvec3(3, 4, 0), dvec3(4, 3, 0)});
}

TEST(TrianglesIntersect, WithoutArea) {
  const dvec3 p(1, 1, 0);
  expect_everywhere(true, flat, {p, p, p});
  expect_everywhere(false, flat, {p + dvec3(0, 0, 1), p + dvec3(0, 0, 1), p + dvec3(0, 0, 1)});
  expect_everywhere(true, flat, {dvec3(1, 1, -1), dvec3(1, 1, 0), dvec3(1, 1, 1)});  // a needle
}

/// Random triangles: they meet exactly where their distance, measured in another way, is nought.
TEST(TrianglesIntersect, AgreesWithTheDistanceOfDenselySampledTriangles) {
  Rng rng(6, 0);
  int met = 0;
  for (int i = 0; i < 3000; ++i) {
    Corners s;
    Corners t;
    for (Corners* corners : {&s, &t}) {
      for (dvec3& corner : *corners) {
        for (int k = 0; k < 3; ++k) {
          corner[k] = rng.uniform();
        }
      }
    }
    double least = 1.0;
    for (int a = 0; a <= 30; ++a) {
      for (int b = 0; a + b <= 30; ++b) {
        const dvec3 point = s[0] + (s[1] - s[0]) * (a / 30.0) + (s[2] - s[0]) * (b / 30.0);
        least = std::min(least,
                         glm::distance(point, closest_point_on_triangle(point, t[0], t[1], t[2])));
      }
    }
    const bool meet = triangles_intersect(s, t);
    met += meet ? 1 : 0;
    if (least > 0.03) {
      EXPECT_FALSE(meet);
    }
    if (meet) {
      EXPECT_LT(least, 0.03);
    }
    if (!meet) {
      EXPECT_GT(least, 0.0);
    }
  }
  EXPECT_GT(met, 300);
}

}  // namespace
}  // namespace collage
