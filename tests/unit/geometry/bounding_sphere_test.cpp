#include "geometry/bounding_sphere.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "base/rng.h"

namespace collage {
namespace {

using Points = std::vector<dvec3>;

dvec3 random_point(Rng& rng) { return {rng.uniform(), rng.uniform(), rng.uniform()}; }

/// The least radius of a sphere round up to four points and through them all, in extended precision
/// by Gaussian elimination; infinite where they do not define one.
long double circumradius(const Points& p, std::array<long double, 3>& center) {
  const std::size_t k = p.size() - 1;
  long double m[3][4] = {};
  const auto difference = [&](std::size_t i, int axis) {
    return static_cast<long double>(p[i + 1][axis]) - p[0][axis];
  };
  const auto dot = [&](std::size_t i, std::size_t j) {
    return difference(i, 0) * difference(j, 0) + difference(i, 1) * difference(j, 1) +
           difference(i, 2) * difference(j, 2);
  };
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j < k; ++j) {
      m[i][j] = 2 * dot(i, j);
    }
    m[i][3] = dot(i, i);
  }
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t row = 0; row < k; ++row) {
      const long double factor = row == i ? 0 : m[row][i] / m[i][i];
      for (int column = 0; column < 4; ++column) {
        m[row][column] -= factor * m[i][column];
      }
    }
  }
  long double square = 0;
  for (int axis = 0; axis < 3; ++axis) {
    long double offset = 0;
    for (std::size_t i = 0; i < k; ++i) {
      offset += m[i][3] / m[i][i] * difference(i, axis);
    }
    center[static_cast<std::size_t>(axis)] = p[0][axis] + offset;
    square += offset * offset;
  }
  return std::isfinite(square) ? std::sqrt(square) : INFINITY;
}

/// The slow twin: the smallest sphere through any one to four points that encloses all.
long double smallest_radius(const Points& points) {
  long double best = INFINITY;
  const std::size_t n = points.size();
  for (unsigned long subset = 1; subset < 1UL << n; ++subset) {
    Points chosen;
    for (std::size_t i = 0; i < n; ++i) {
      if ((subset >> i & 1U) != 0) {
        chosen.push_back(points[i]);
      }
    }
    if (chosen.size() > 4) {
      continue;
    }
    std::array<long double, 3> center{};
    const long double radius = circumradius(chosen, center);
    bool encloses = true;
    for (const dvec3& p : points) {
      encloses = encloses && std::hypot(p.x - center[0], p.y - center[1], p.z - center[2]) <=
                                 radius * (1 + 1e-14L) + 1e-300L;
    }
    best = encloses ? std::min(best, radius) : best;
  }
  return best;
}

void expect_smallest(const Points& points, double radius) {
  const Sphere sphere = smallest_enclosing_sphere(points);
  EXPECT_NEAR(sphere.radius / radius, 1.0, 1e-12);
  for (const dvec3& p : points) {
    EXPECT_LE(glm::distance(p, sphere.center), sphere.radius);
  }
}

TEST(BoundingSphere, AgreesWithAllSubsets) {
  Rng rng(3, 1);
  for (int i = 0; i < 300; ++i) {
    Points points;
    const std::size_t count = 1 + rng.below(9);
    for (std::size_t k = 0; k < count; ++k) {
      points.push_back(random_point(rng));
    }
    const Sphere sphere = smallest_enclosing_sphere(points);
    EXPECT_NEAR(sphere.radius, static_cast<double>(smallest_radius(points)), 1e-13) << "case " << i;
  }
}

TEST(BoundingSphere, KnownShapes) {
  const double root = std::sqrt(3.0);
  expect_smallest(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}},
      root / 2);
  expect_smallest({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, root);
  expect_smallest({{0, 0, 0}, {10, 0, 0}, {5, 1, 0}}, 5.0);            // obtuse
  expect_smallest({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {7, 0, 0}}, 3.5);  // on a line
  expect_smallest({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0.6, 0.8, 0}},
                  1.0);  // on a circle
}

TEST(BoundingSphere, OnePointManyTimes) {
  const Points points(20, dvec3(3, 4, 5));
  const Sphere sphere = smallest_enclosing_sphere(points);
  EXPECT_EQ(sphere.center, dvec3(3, 4, 5));
  EXPECT_EQ(sphere.radius, 0.0);
}

TEST(BoundingSphere, DoesNotDependOnSizeOrPlace) {
  Rng rng(3, 2);
  Points unit;
  for (int i = 0; i < 500; ++i) {
    unit.push_back(random_point(rng));
  }
  const double radius = smallest_enclosing_sphere(unit).radius;
  for (const double size : {1e-10, 1e-5, 1.0, 1e5, 1e10}) {
    Points points = unit;
    for (dvec3& p : points) {
      p *= size;
    }
    expect_smallest(points, size * radius);
  }
  Points far = unit;
  for (dvec3& p : far) {
    p += dvec3(1e6, -1e6, 1e6);
  }
  const Sphere sphere = smallest_enclosing_sphere(far);
  EXPECT_NEAR(sphere.radius, radius, 1e-9);
  EXPECT_LE(farthest_point(far, sphere.center).distance, sphere.radius);
}

TEST(BoundingSphere, CosphericalPointsGiveTheirSphere) {
  Rng rng(3, 3);
  Points points;
  for (int i = 0; i < 5000; ++i) {
    points.push_back(dvec3(7, 8, 9) + 2.0 * glm::normalize(random_point(rng) - dvec3(0.5)));
  }
  expect_smallest(points, 2.0);
}

TEST(BoundingSphere, NeedlesAndFlatSetsAreStillEnclosed) {
  Rng rng(3, 4);
  for (int i = 0; i < 200; ++i) {
    Points points;
    const dvec3 shape(1.0, std::pow(10.0, -12.0 * rng.uniform()),
                      std::pow(10.0, -12.0 * rng.uniform()));
    for (int k = 0; k < 30; ++k) {
      points.push_back(shape * random_point(rng));
    }
    const Sphere sphere = smallest_enclosing_sphere(points);
    EXPECT_LE(farthest_point(points, sphere.center).distance, sphere.radius);
    // No sphere that encloses them is smaller than half their diameter; Jung's theorem bounds it
    // above.
    double diameter = 0.0;
    for (const dvec3& p : points) {
      diameter = std::max(diameter, farthest_point(points, p).distance);
    }
    EXPECT_LE(sphere.radius, diameter * std::sqrt(3.0 / 8.0) * (1 + 1e-14));
  }
}

TEST(FarthestPoint, FirstOfEquals) {
  const FarthestPoint found = farthest_point(Points{{1, 0, 0}, {0, 2, 0}, {0, -2, 0}}, dvec3(0.0));
  EXPECT_EQ(found.index, 1U);
  EXPECT_EQ(found.distance, 2.0);
  EXPECT_EQ(found.direction, dvec3(0, 1, 0));
}

}  // namespace
}  // namespace collage
