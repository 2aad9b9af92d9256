#include "geometry/planar_region.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "base/rng.h"
#include "unit/geometry/test_letters.h"

namespace collage {
namespace {

Contour square(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

Contour reversed(Contour contour) {
  std::reverse(contour.begin(), contour.end());
  return contour;
}

double area_of_triangles(const Region& region, const std::vector<uvec3>& triangles) {
  const std::vector<dvec2> points = all_points(region);
  double sum = 0.0;
  for (const uvec3& t : triangles) {
    const double one = area(Contour{points.at(t.x), points.at(t.y), points.at(t.z)});
    EXPECT_GT(one, 0.0);
    sum += one;
  }
  return sum;
}

/// A region with as many triangles as its points and holes call for, and its own area in them.
void expect_sound(const Region& region, std::size_t parts) {
  const auto triangles = triangulated(region);
  ASSERT_TRUE(triangles.has_value());
  EXPECT_NEAR(area_of_triangles(region, *triangles), area(region), 1e-9);
  const std::size_t holes = region.size() - parts;
  EXPECT_EQ(triangles->size(), point_count(region) + 2 * holes - 2 * parts);
}

TEST(PlanarRegion, UnitesWhatOverlaps) {
  const auto region = united({square(0, 0, 2), square(1, 1, 2)});
  ASSERT_TRUE(region);
  EXPECT_EQ(region->size(), 1U);
  EXPECT_EQ(area(*region), 7.0);
  expect_sound(*region, 1);
}

TEST(PlanarRegion, KeepsToTheLeftWhicheverWayTheContoursRun) {
  for (const Contour& outline : {square(0, 0, 3), reversed(square(0, 0, 3))}) {
    const bool turned = area(outline) < 0;
    const Contour hole = turned ? square(1, 1, 1) : reversed(square(1, 1, 1));
    const auto region = united({outline, hole});
    ASSERT_TRUE(region);
    EXPECT_EQ(region->size(), 2U);
    EXPECT_EQ(area(*region), 8.0);
    expect_sound(*region, 1);
  }
  const auto same_way = united({square(0, 0, 3), square(1, 1, 1)});
  ASSERT_TRUE(same_way);
  EXPECT_EQ(area(*same_way), 9.0);
}

TEST(PlanarRegion, DrawsApartWhatTouchesInAPoint) {
  const auto corners = united({square(0, 0, 1), square(1, 1, 1)});
  ASSERT_TRUE(corners);
  EXPECT_EQ(corners->size(), 2U);
  EXPECT_NEAR(area(*corners), 2.0, 0.002);
  expect_sound(*corners, 2);
  // A hole that touches the outline in a point, and a corner that touches a side.
  const auto hole = united({square(0, 0, 3), {{0, 1.5}, {1, 2}, {1, 1}}});
  ASSERT_TRUE(hole);
  expect_sound(*hole, 1);
  const auto side = united({square(0, 0, 1), {{1, 0.5}, {2, 0}, {2, 1}}});
  ASSERT_TRUE(side);
  EXPECT_EQ(side->size(), 2U);
  expect_sound(*side, 2);
}

TEST(PlanarRegion, LeavesOutWhatHasNoArea) {
  const auto nothing = united({{{0, 0}, {1, 0}, {2, 0}}, {{0, 0}, {1, 1}}, {{0, 0}}, {}});
  ASSERT_TRUE(nothing);
  EXPECT_TRUE(nothing->empty());
  EXPECT_TRUE(triangulated({}).value().empty());
}

TEST(PlanarRegion, LeavesOutSpikes) {
  // There and back again, a hundred thousand points, wherever the contour starts.
  Contour contour = square(0, 0, 1);
  for (int i = 1; i < 50000; ++i) {
    contour.emplace_back(0.0, 1.0 + i * grid_step);
  }
  for (int i = 50000; i > 0; --i) {
    contour.emplace_back(0.0, 1.0 + i * grid_step);
  }
  for (int i = 0; i < 8; ++i) {
    std::rotate(contour.begin(), contour.begin() + 12345, contour.end());
    const auto region = united({contour});
    ASSERT_TRUE(region);
    EXPECT_EQ(area(*region), 1.0);
    EXPECT_EQ(point_count(*region), 4U);
  }
}

TEST(PlanarRegion, IsAsLargeAsScanLinesSay) {
  Rng rng(1, 1);
  for (int i = 0; i < 300; ++i) {
    std::vector<Contour> contours(1 + rng.below(4));
    for (Contour& contour : contours) {
      for (std::uint64_t k = 3 + rng.below(12); k > 0; --k) {
        // Every other time on a coarse grid, where much coincides.
        const dvec2 point(rng.uniform(), rng.uniform());
        contour.push_back(i % 2 == 0 ? point : glm::round(6.0 * point) / 6.0);
      }
    }
    const auto region = united(contours);
    ASSERT_TRUE(region) << i;
    EXPECT_NEAR(area(*region), inked_area(contours, 4000), 0.01) << i;
    ASSERT_TRUE(triangulated(*region)) << i;
    std::set<std::pair<double, double>> places;
    for (const Contour& contour : *region) {
      for (const dvec2& point : contour) {
        EXPECT_TRUE(places.emplace(point.x, point.y).second) << i;
        EXPECT_EQ(point, on_grid(point));
      }
    }
  }
}

TEST(PlanarRegion, RefusesWhatIsNone) {
  EXPECT_FALSE(triangulated({square(0, 0, 2), square(1, 1, 2)}));
  EXPECT_FALSE(triangulated({reversed(square(0, 0, 2))}));
  EXPECT_FALSE(triangulated({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}));
}

TEST(PlanarRegion, RefusesMoreCrossingsThanLettersHave) {
  Contour star;
  for (int i = 0; i < 999; ++i) {
    const double angle = 2.0 * std::numbers::pi * i * 499 / 999;
    star.emplace_back(std::cos(angle), std::sin(angle));
  }
  EXPECT_FALSE(united({star}));
}

}  // namespace
}  // namespace collage
