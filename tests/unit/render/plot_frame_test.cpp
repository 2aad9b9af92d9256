#include "render/plot_frame.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace collage {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Mark = PlotSeries::Mark;

Plot plot_of(const PlotSeries& series, AxisScale scale = AxisScale::linear) {
  return {.title = "", .x = {"x"}, .y = {"y", scale}, .series = {series}};
}

TEST(PlotFrame, lies_within_the_view_box_and_leaves_the_margin) {
  const PlotFrame frame(plot_of({.x = {0, 10}, .y = {0, 123456}}), 100.0);
  EXPECT_GT(frame.left(), estimated_width("100,000"));
  EXPECT_LE(frame.right(), PlotFrame::width - 100.0);
  EXPECT_EQ(frame.x_of(0.0), frame.left());
  EXPECT_EQ(frame.x_of(10.0), frame.right());
}

TEST(PlotFrame, a_linear_y_axis_contains_0_on_either_side) {
  const PlotFrame above(plot_of({.x = {0, 1}, .y = {50, 60}}), 0.0);
  EXPECT_EQ(above.base(), PlotFrame::bottom);
  const PlotFrame below(plot_of({.x = {0, 1}, .y = {-50, -60}}), 0.0);
  EXPECT_EQ(below.base(), PlotFrame::top);
}

TEST(PlotFrame, the_smallest_bar_has_a_height_on_a_logarithmic_axis) {
  const PlotSeries bars{.mark = Mark::bars, .x = {0, 1, 2}, .y = {1, 100}};
  const PlotFrame frame(plot_of(bars, AxisScale::logarithmic), 0.0);
  EXPECT_LT(frame.y_of(1.0), frame.base() - 1.0);
}

TEST(PlotFrame, has_fewer_ticks_where_they_are_long) {
  const auto ticks = [](double to, double margin) {
    const std::string svg = PlotFrame(plot_of({.x = {0, to}, .y = {0, 1}}), margin).svg();
    const std::string x_texts = svg.substr(0, svg.find("text-anchor=\"end\""));
    std::size_t count = 0;
    for (std::size_t at = x_texts.find("<text"); at != std::string::npos;
         at = x_texts.find("<text", at + 1)) {
      ++count;
    }
    return count;
  };
  EXPECT_EQ(ticks(6.0, 0.0), 7U);
  EXPECT_LT(ticks(6e6, 150.0), 5U);
}

TEST(PlotFrame, escapes_its_labels) {
  const Plot plot{.title = "", .x = {"<x>"}, .y = {"\"&"}, .series = {}};
  EXPECT_THAT(PlotFrame(plot, 0.0).svg(), HasSubstr(">&lt;x&gt;<"));
  EXPECT_THAT(PlotFrame(plot, 0.0).svg(), HasSubstr(">&quot;&amp;<"));
  EXPECT_THAT(PlotFrame(plot, 0.0).svg(), Not(HasSubstr("<x>")));
}

TEST(Shortened, cuts_between_characters) {
  EXPECT_EQ(shortened("größe", 5), "größe");
  EXPECT_EQ(shortened("größen", 5), "größ…");
  EXPECT_EQ(shortened("", 5), "");
  EXPECT_EQ(shortened("\x80\x80\x80", 1), "\x80\x80\x80") << "no UTF-8, but short";
}

}  // namespace
}  // namespace collage
