#include "base/text.h"

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <gtest/gtest.h>

#include "base/rng.h"

namespace collage {
namespace {

TEST(NumberText, IsTheShortest) {
  EXPECT_EQ(number_text(0.0), "0");
  EXPECT_EQ(number_text(1.5), "1.5");
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(-0.001), "-0.001");
  EXPECT_EQ(number_text(1e30), "1e+30");
}

TEST(NumberText, ReadsBackTheSame) {
  Rng rng(1, 1);
  for (int i = 0; i < 100000; ++i) {
    const double value = std::bit_cast<double>(rng.next());
    if (std::isfinite(value)) {
      EXPECT_EQ(std::strtod(number_text(value).c_str(), nullptr), value);
    }
  }
}

TEST(Grouped, PartsThousands) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1000), "1,000");
  EXPECT_EQ(grouped(334972), "334,972");
  EXPECT_EQ(grouped(std::numeric_limits<std::uint64_t>::max()), "18,446,744,073,709,551,615");
}

}  // namespace
}  // namespace collage
