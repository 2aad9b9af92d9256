#include "geometry/predicates.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/rng.h"

namespace collage {
namespace {

using glm::dvec2;
using glm::dvec3;

TEST(Orient3d, TellsBelowFromAbove) {
  const dvec3 a(0, 0, 0);
  const dvec3 b(1, 0, 0);
  const dvec3 c(0, 1, 0);
  EXPECT_EQ(orient3d(a, b, c, {0.3, 0.3, -1}), 1);
  EXPECT_EQ(orient3d(a, b, c, {0.3, 0.3, 1}), -1);
  EXPECT_EQ(orient3d(a, b, c, {7, -5, 0}), 0);
  EXPECT_EQ(orient3d(a, c, b, {0.3, 0.3, 1}), 1);
}

TEST(Orient3d, IsExactForThePlanesNextToAPoint) {
  // On the plane x + y + z = 1.5 with coordinates that are exact in binary; one step of the last
  // place away the answer changes, which double arithmetic alone gets wrong for far points.
  const dvec3 a(0.5, 0.5, 0.5);
  const dvec3 b(1e6 + 0.25, -1e6 + 0.25, 1.0);
  const dvec3 c(-1e6 + 0.25, 1.0, 1e6 + 0.25);
  const dvec3 d(-3e6 + 0.5, 1e6 + 0.5, 2e6 + 0.5);
  EXPECT_EQ(orient3d(a, b, c, d), 0);
  const dvec3 above(d.x, d.y, std::nextafter(d.z, 1e9));
  const dvec3 below(d.x, d.y, std::nextafter(d.z, -1e9));
  EXPECT_EQ(orient3d(a, b, c, above) * orient3d(a, b, c, below), -1);
}

TEST(Orient3d, ChangesSignWhereTwoPointsAreSwapped) {
  Rng rng(4, 0);
  for (int i = 0; i < 2000; ++i) {
    dvec3 p[4];
    for (dvec3& q : p) {
      for (int k = 0; k < 3; ++k) {
        q[k] = std::floor(rng.uniform() * 4.0) * 0.1;  // often in one plane, but for rounding
      }
    }
    const int sign = orient3d(p[0], p[1], p[2], p[3]);
    EXPECT_EQ(orient3d(p[1], p[0], p[2], p[3]), -sign);
    EXPECT_EQ(orient3d(p[0], p[1], p[3], p[2]), -sign);
    EXPECT_EQ(orient3d(p[1], p[2], p[0], p[3]), sign);
  }
}

TEST(Orient3d, HoldsForTinyAndHugeCoordinates) {
  for (const double s : {1e-120, 1e-20, 1e20, 1e90}) {
    EXPECT_EQ(orient3d(s * dvec3(0, 0, 0), s * dvec3(1, 0, 0), s * dvec3(0, 1, 0),
                       s * dvec3(0.3, 0.3, -1)),
              1);
  }
}

TEST(Orient2d, IsExact) {
  EXPECT_EQ(orient2d({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(orient2d({0, 0}, {0, 1}, {1, 0}), -1);
  EXPECT_EQ(orient2d({0.5, 0.5}, {12, 12}, {24, 24}), 0);
  EXPECT_EQ(orient2d({0.5, 0.5}, {12, 12}, {24, std::nextafter(24.0, 25.0)}), 1);
}

}  // namespace
}  // namespace collage
