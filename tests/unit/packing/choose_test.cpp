#include "packing/choose.h"

#include <array>

#include <gtest/gtest.h>

namespace collage {
namespace {

PackingOptions options(Scaling scaling, Choose choose) {
  PackingOptions result;
  result.scaling = scaling;
  result.choose = choose;
  return result;
}

/// How often each of three elements comes up in 3,000 holes of the given radius.
std::array<int, 3> tally(const Chooser& chooser, double radius) {
  std::array<int, 3> count{};
  for (std::size_t i = 0; i < 3000; ++i) {
    Rng rng(1, i);
    if (const auto choice = chooser.choose(radius, i, rng)) {
      ++count[choice->element];
    }
  }
  return count;
}

TEST(Chooser, TakesTheLargestThatFits) {
  const Chooser chooser({{1.0, {1.0, 0.5}, 1.0}, {0.8, {1.0}, 1.0}, {3.0, {0.5}, 1.0}},
                        options(Scaling::fixed, Choose::largest));
  Rng rng(1, 0);
  EXPECT_EQ(chooser.choose(2.0, 0, rng)->element, 2U);
  EXPECT_EQ(chooser.choose(2.0, 0, rng)->scale, 0.5);
  EXPECT_EQ(chooser.choose(1.2, 0, rng)->element, 0U);
  EXPECT_EQ(chooser.choose(0.9, 0, rng)->element, 1U);
  EXPECT_EQ(chooser.choose(0.6, 0, rng)->scale, 0.5);
  EXPECT_FALSE(chooser.choose(0.49, 0, rng));
}

TEST(Chooser, BreaksTiesBySeedSoThatAllAreUsed) {
  const Chooser chooser({{1.0, {1.0}, 1.0}, {2.0, {0.5}, 1.0}, {1.0, {1.0}, 1.0}},
                        options(Scaling::fixed, Choose::largest));
  for (const int count : tally(chooser, 1.5)) {
    EXPECT_NEAR(count, 1000, 120);
  }
}

TEST(Chooser, ScalesToTheHole) {
  const Chooser chooser({{2.0, {1.0}, 1.0}, {1.0, {1.0}, 1.0}, {4.0, {1.0}, 1.0}},
                        options(Scaling::to_hole, Choose::largest));
  Rng rng(1, 0);
  const auto choice = chooser.choose(0.5, 0, rng);
  EXPECT_DOUBLE_EQ(choice->scale, choice->element == 0 ? 0.25 : choice->element == 1 ? 0.5 : 0.125);
  for (const int count : tally(chooser, 0.5)) {
    EXPECT_NEAR(count, 1000, 120);
  }
}

TEST(Chooser, KeepsElementsToTheirStretch) {
  const Chooser chooser({{1.0, {1.0}, 1.0, 0.0, 0.5}, {1.0, {0.5}, 1.0, 0.4, 1.0}},
                        options(Scaling::fixed, Choose::largest));
  Rng rng(1, 0);
  EXPECT_EQ(chooser.choose(1.0, 0, rng, 0.1)->element, 0U);
  EXPECT_EQ(chooser.choose(1.0, 0, rng, 0.45)->element, 0U);
  EXPECT_EQ(chooser.choose(1.0, 0, rng, 0.9)->element, 1U);
  EXPECT_FALSE(chooser.choose(0.6, 0, rng, 0.1));
  EXPECT_TRUE(chooser.fits(0.6));
  EXPECT_FALSE(chooser.fits(0.4));
}

TEST(Chooser, Alternates) {
  const Chooser chooser({{1.0, {1.0}, 1.0}, {1.0, {1.0}, 1.0}, {1.0, {1.0}, 1.0}},
                        options(Scaling::to_hole, Choose::alternate));
  EXPECT_EQ(tally(chooser, 1.0), (std::array<int, 3>{1000, 1000, 1000}));
}

TEST(Chooser, PassesOverElementsThatDoNotFitInTurn) {
  const Chooser chooser({{1.0, {1.0}, 1.0}, {9.0, {1.0}, 1.0}, {1.0, {1.0}, 1.0}},
                        options(Scaling::fixed, Choose::alternate));
  EXPECT_EQ(tally(chooser, 1.0), (std::array<int, 3>{1000, 0, 2000}));
}

TEST(Chooser, WeighsAmongThoseThatFit) {
  const Chooser chooser({{1.0, {1.0}, 3.0}, {1.0, {1.0}, 1.0}, {9.0, {1.0}, 100.0}},
                        options(Scaling::fixed, Choose::weighted));
  const auto count = tally(chooser, 1.0);
  EXPECT_NEAR(count[0], 2250, 100);
  EXPECT_NEAR(count[1], 750, 100);
  EXPECT_EQ(count[2], 0);
}

}  // namespace
}  // namespace collage
