#include "base/rng.h"

#include <array>
#include <bit>
#include <cmath>

#include <gtest/gtest.h>

namespace collage {
namespace {

TEST(Rng, IsTheSameForTheSameSeedAndStream) {
  Rng a(1, 2);
  Rng b(1, 2);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(a.next(), b.next());
  }
  EXPECT_NE(Rng(1, 2).next(), Rng(1, 3).next());
  EXPECT_NE(Rng(1, 2).next(), Rng(2, 2).next());
}

TEST(Rng, NeighbouringSeedsAndStreamsAreUnlike) {
  int bits = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    bits += std::popcount(Rng(i, 0).next() ^ Rng(i + 1, 0).next());
    bits += std::popcount(Rng(0, i).next() ^ Rng(0, i + 1).next());
  }
  EXPECT_NEAR(bits / 2000.0, 32.0, 0.5);
}

TEST(Rng, IsUniform) {
  Rng rng(7, 7);
  double sum = 0.0;
  std::array<int, 10> counts{};
  constexpr int draws = 100000;
  for (int i = 0; i < draws; ++i) {
    const double x = rng.uniform();
    ASSERT_GE(x, 0.0);
    ASSERT_LT(x, 1.0);
    sum += x;
    const std::uint64_t k = rng.below(10);
    ASSERT_LT(k, 10U);
    ++counts[k];
  }
  EXPECT_NEAR(sum / draws, 0.5, 0.005);
  for (const int count : counts) {
    EXPECT_NEAR(count, draws / 10, 5 * std::sqrt(draws / 10));
  }
}

TEST(Rng, BelowOneIsZero) { EXPECT_EQ(Rng(1, 1).below(1), 0U); }

}  // namespace
}  // namespace collage
