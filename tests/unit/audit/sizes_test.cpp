#include "audit/sizes.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "base/rng.h"

namespace collage {
namespace {

std::vector<double> power_law_sizes(double exponent, std::size_t count, std::uint64_t seed) {
  Rng rng(seed, 0);
  std::vector<double> sizes;
  for (std::size_t i = 0; i < count; ++i) {
    sizes.push_back(0.01 * std::pow(1.0 - rng.uniform(), -1.0 / (exponent - 1.0)));
  }
  return sizes;
}

TEST(Sizes, ExponentIsFoundWithinItsError) {
  for (const double exponent : {1.5, 2.5, 3.47}) {
    double squares = 0.0;
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      const auto law = size_distribution(power_law_sizes(exponent, 2000, seed))->power_law;
      squares += std::pow((law->exponent - exponent) / law->error, 2) / 50.0;
    }
    EXPECT_GT(squares, 0.5);  // 1 ± 0.2 where the error is the standard error
    EXPECT_LT(squares, 1.6);
  }
}

TEST(Sizes, ExponentDoesNotDependOnTheUnit) {
  auto sizes = power_law_sizes(2.0, 100, 1);
  const double exponent = size_distribution(sizes)->power_law->exponent;
  for (double& size : sizes) {
    size *= 1e6;
  }
  EXPECT_NEAR(size_distribution(sizes)->power_law->exponent, exponent, 1e-12);
}

TEST(Sizes, ExponentOfTwoSizesIsThatOfTheFormula) {
  const auto sizes = size_distribution(std::vector<double>{1.0, std::exp(1.0)});
  EXPECT_DOUBLE_EQ(sizes->power_law->exponent, 3.0);
  EXPECT_DOUBLE_EQ(sizes->power_law->error, std::sqrt(2.0));
}

TEST(Sizes, HistogramHasBinsOfEqualRatio) {
  const auto sizes =
      size_distribution(std::vector<double>{1.0, 1.9, 2.1, 3.9, 4.1, 7.9, 8.1, 9.0, 16.0}, 4);
  EXPECT_EQ(sizes->histogram, (std::vector<std::uint64_t>{2, 2, 2, 3}));
  EXPECT_EQ(sizes->smallest, 1.0);
  EXPECT_EQ(sizes->largest, 16.0);
}

TEST(Sizes, AllTheSameAreOneBinWithoutAnExponent) {
  const auto sizes = size_distribution(std::vector<double>(7, 0.3));
  EXPECT_EQ(sizes->histogram, std::vector<std::uint64_t>{7});
  EXPECT_FALSE(sizes->power_law);
  EXPECT_FALSE(size_distribution({}));
}

}  // namespace
}  // namespace collage
