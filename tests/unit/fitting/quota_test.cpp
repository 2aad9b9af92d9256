#include "fitting/quota.h"

#include <cmath>

#include <gtest/gtest.h>

namespace collage {
namespace {

TEST(Quota, HoldsNumbersToWeights) {
  const std::vector<double> weights{5.0, 3.0, 0.0, 2.0};
  Quota quota(weights);
  std::vector<int> counts(4, 0);
  for (int n = 1; n <= 1000; ++n) {
    const auto next = quota.next({1, 1, 1, 1});
    ASSERT_TRUE(next);
    quota.count(*next);
    ++counts[*next];
    for (std::size_t e = 0; e < 4; ++e) {
      EXPECT_LE(std::abs(counts[e] - n * weights[e] / 10.0), 1.0);
    }
  }
}

TEST(Quota, EndsWhereOneThatIsBehindHasNoPlaceLeft) {
  Quota quota(std::vector<double>{1.0, 1.0});
  for (int n = 0; n < 100; ++n) {
    quota.count(*quota.next({1, 1}));
  }
  int more = 0;
  while (const auto next = quota.next({1, 0})) {
    EXPECT_EQ(*next, 0U);
    quota.count(*next);
    ++more;
  }
  EXPECT_GE(more, 3);
  EXPECT_LE(more, 12);
}

TEST(Quota, AnElementThatNeverFitsDoesNotCount) {
  Quota quota(std::vector<double>{1.0, 1.0});
  for (int n = 0; n < 100; ++n) {
    const auto next = quota.next({1, 0});
    ASSERT_TRUE(next);
    quota.count(*next);
  }
  EXPECT_FALSE(quota.next({0, 0}));
}

}  // namespace
}  // namespace collage
