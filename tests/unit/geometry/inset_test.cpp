#include "geometry/inset.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace collage {
namespace {

Contour box(double width, double height) {
  return {{0, 0}, {width, 0}, {width, height}, {0, height}};
}

Contour circle(double radius, int corners) {
  Contour contour;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners;
    contour.push_back(on_grid(radius * dvec2(std::cos(angle), std::sin(angle))));
  }
  return contour;
}

double area_below(const Inset& inset) {
  double sum = 0.0;
  for (const auto& face : inset.faces) {
    Contour flat;
    for (const auto point : face) {
      flat.emplace_back(inset.points.at(point));
    }
    EXPECT_GT(area(flat), 0.0);
    sum += area(flat);
  }
  return sum;
}

TEST(Inset, OfARectangleIsASmallerOne) {
  const auto drawn_in = inset({box(4, 2)}, 0.5);
  ASSERT_TRUE(drawn_in);
  EXPECT_EQ(area(drawn_in->inner), 3.0);
  EXPECT_EQ(drawn_in->faces.size(), 4U);
  EXPECT_EQ(area_below(*drawn_in), 5.0);
  EXPECT_EQ(drawn_in->cap.size(), 2U);
  EXPECT_FALSE(inset({box(4, 2)}, 1.0));
  EXPECT_FALSE(inset({box(4, 2)}, 3.0));
}

TEST(Inset, HolesGrow) {
  Contour hole = {{1, 1}, {1, 3}, {3, 3}, {3, 1}};
  const auto drawn_in = inset({box(4, 4), hole}, 0.25);
  ASSERT_TRUE(drawn_in);
  EXPECT_EQ(area(drawn_in->inner), 3.5 * 3.5 - 2.5 * 2.5);
  EXPECT_FALSE(inset({box(4, 4), hole}, 0.5));
  EXPECT_FALSE(inset({box(4, 4), hole}, 0.75));
}

TEST(Inset, OfNothingIsTheRegion) {
  const Region region{box(4, 2)};
  const auto same = inset(region, 0.0);
  ASSERT_TRUE(same);
  EXPECT_EQ(same->inner, region);
  EXPECT_TRUE(same->faces.empty());
}

TEST(Inset, SidesThatShrinkToNothingAreLeftOut) {
  // A corner cut off, of which nothing is left further in.
  const Region region{{{0, 0}, {3.9, 0}, {4, 0.1}, {4, 4}, {0, 4}}};
  const auto drawn_in = inset(region, 1.0);
  ASSERT_TRUE(drawn_in);
  EXPECT_EQ(drawn_in->inner.at(0).size(), 4U);
  EXPECT_NEAR(area(drawn_in->inner), 4.0, 1e-3);
  EXPECT_NEAR(area_below(*drawn_in), area(region) - area(drawn_in->inner), 1e-9);
  const auto round = inset({circle(1.0, 60)}, 0.9);
  ASSERT_TRUE(round);
  EXPECT_NEAR(area(round->inner), std::numbers::pi * 0.01, 1e-3);
}

TEST(Inset, StopsWhereARegionWouldPart) {
  // Two rooms and a door of width 0.2.
  const Region region{{{0, 0},
                       {2, 0},
                       {2, 0.9},
                       {3, 0.9},
                       {3, 0},
                       {5, 0},
                       {5, 2},
                       {3, 2},
                       {3, 1.1},
                       {2, 1.1},
                       {2, 2},
                       {0, 2}}};
  EXPECT_TRUE(inset(region, 0.09));
  EXPECT_FALSE(inset(region, 0.1));
  EXPECT_FALSE(inset(region, 0.2));
  EXPECT_FALSE(inset(region, 0.5));
  EXPECT_FALSE(inset(region, 0.9));
}

}  // namespace
}  // namespace collage
