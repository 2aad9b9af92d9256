#include "render/plot_axis.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/rng.h"

namespace collage {
namespace {

using ::testing::ElementsAre;
using enum AxisScale;
using enum AxisEnds;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<std::string> texts(const PlotAxis& axis) {
  std::vector<std::string> texts;
  for (const PlotAxis::Tick& tick : axis.ticks()) {
    texts.push_back(tick.text);
  }
  return texts;
}

TEST(PlotAxis, linear_ticks_are_steps_of_1_2_or_5) {
  EXPECT_THAT(texts({linear, at_round_numbers, {0, 14.39}, 6}), ElementsAre("0", "5", "10", "15"));
  EXPECT_THAT(texts({linear, at_data, {1, 2043}, 6}),
              ElementsAre("500", "1,000", "1,500", "2,000"));
  EXPECT_THAT(texts({linear, at_round_numbers, {-0.07, 0.1}, 6}),
              ElementsAre("−0.10", "−0.05", "0", "0.05", "0.10"));
}

TEST(PlotAxis, logarithmic_ticks_are_1_2_5_or_decades) {
  EXPECT_THAT(texts({logarithmic, at_data, {0.012, 0.13}, 6}), ElementsAre("0.02", "0.05", "0.1"));
  EXPECT_THAT(texts({logarithmic, at_round_numbers, {1, 620}, 6}),
              ElementsAre("1", "10", "100", "1,000"));
  EXPECT_THAT(texts({logarithmic, at_data, {1e-9, 1e3}, 6}),
              ElementsAre("10⁻⁸", "10⁻⁶", "10⁻⁴", "10⁻²", "10⁰", "10²"));
}

TEST(PlotAxis, large_and_small_numbers_are_written_as_powers) {
  EXPECT_THAT(texts({linear, at_round_numbers, {0, 3e7}, 4}),
              ElementsAre("0", "10⁷", "2×10⁷", "3×10⁷"));
  EXPECT_THAT(texts({linear, at_data, {1.5e-6, 2.5e-6}, 3}),
              ElementsAre("1.5×10⁻⁶", "2.0×10⁻⁶", "2.5×10⁻⁶"));
}

TEST(PlotAxis, ends_where_it_is_told) {
  const PlotAxis at_its_data(linear, at_data, {1, 2043}, 6);
  EXPECT_EQ(at_its_data.from(), 1.0);
  EXPECT_EQ(at_its_data.to(), 2043.0);
  const PlotAxis rounded(logarithmic, at_round_numbers, {3, 700}, 6);
  EXPECT_EQ(rounded.from(), 2.0);
  EXPECT_EQ(rounded.to(), 1000.0);
}

TEST(PlotAxis, fractions_follow_the_scale) {
  EXPECT_DOUBLE_EQ(PlotAxis(linear, at_data, {-1, 3}, 6).fraction(0.0), 0.25);
  EXPECT_DOUBLE_EQ(PlotAxis(logarithmic, at_data, {1, 1e4}, 6).fraction(10.0), 0.25);
}

TEST(PlotAxis, leaves_out_what_it_cannot_show) {
  const PlotAxis axis(linear, at_data, {nan, 2, infinity, 4, -infinity, 1e300}, 6);
  EXPECT_EQ(axis.from(), 2.0);
  EXPECT_EQ(axis.to(), 4.0);
  EXPECT_EQ(PlotAxis(logarithmic, at_data, {-1, 0, 1e-320, 2, 300}, 6).from(), 2.0);
}

TEST(PlotAxis, has_room_around_nothing_and_around_one_value) {
  for (const AxisScale scale : {linear, logarithmic}) {
    for (const AxisEnds ends : {at_data, at_round_numbers}) {
      for (const std::vector<double>& values :
           {std::vector<double>{}, {nan}, {1.0}, {3.7}, {1e-90}, {1e90}, {7.0, 7.0}}) {
        const PlotAxis axis(scale, ends, values, 6);
        EXPECT_LT(axis.from(), axis.to());
        EXPECT_GE(axis.ticks().size(), 2U);
      }
    }
  }
  EXPECT_EQ(PlotAxis(linear, at_data, {0.0}, 6).to(), 1.0);
}

TEST(PlotAxis, ticks_are_few_ascending_and_on_the_axis) {
  Rng rng(7, 0);
  for (int i = 0; i < 20000; ++i) {
    const AxisScale scale = rng.uniform() < 0.5 ? linear : logarithmic;
    const AxisEnds ends = rng.uniform() < 0.5 ? at_data : at_round_numbers;
    const int max_ticks = 3 + static_cast<int>(rng.uniform() * 6.0);
    const double one = std::pow(10.0, 200.0 * rng.uniform() - 100.0);
    const double other = one * std::pow(10.0, 6.0 * rng.uniform() * rng.uniform() - 3.0);
    const double sign = scale == linear && rng.uniform() < 0.5 ? -1.0 : 1.0;
    const PlotAxis axis(scale, ends, {one, sign * other}, max_ticks);
    ASSERT_LE(axis.ticks().size(), static_cast<std::size_t>(max_ticks));
    ASSERT_TRUE(std::isfinite(axis.from()) && std::isfinite(axis.to()));
    double last = -1e-6;
    for (const PlotAxis::Tick& tick : axis.ticks()) {
      const double fraction = axis.fraction(tick.value);
      ASSERT_GT(fraction, last) << one << " " << sign * other;
      ASSERT_LT(fraction, 1.0 + 1e-6);
      last = fraction;
    }
  }
}

TEST(ShortNumber, is_for_people) {
  EXPECT_EQ(short_number(2043.0), "2,043");
  EXPECT_EQ(short_number(1234567.0), "1,234,567");
  EXPECT_EQ(short_number(14.3944), "14.39");
  EXPECT_EQ(short_number(-0.5), "−0.5");
  EXPECT_EQ(short_number(0.0), "0");
  EXPECT_EQ(short_number(-3.2e-6), "−3.2×10⁻⁶");
  EXPECT_EQ(short_number(1e9), "10⁹");
  EXPECT_EQ(short_number(nan), "–");
}

}  // namespace
}  // namespace collage
