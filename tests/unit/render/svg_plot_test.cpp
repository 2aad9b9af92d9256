#include "render/svg_plot.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace collage {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Mark = PlotSeries::Mark;
using enum AxisScale;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::string svg(const PlotSeries& series, AxisScale x = linear, AxisScale y = linear) {
  return svg_plot({.title = "Title", .x = {"x", x}, .y = {"y", y}, .series = {series}});
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

/// The path data of the first curve.
std::string curve(const std::string& svg) {
  const std::string start = "class=\"curve\" d=\"";
  const std::size_t from = svg.find(start) + start.size();
  return svg.substr(from, svg.find('"', from) - from);
}

TEST(SvgPlot, is_a_picture_with_a_title_and_its_extent_in_words) {
  const std::string text = svg({.x = {1, 2043}, .y = {0.8, 14.39}});
  EXPECT_THAT(text, HasSubstr("role=\"img\""));
  EXPECT_THAT(text, HasSubstr("<title>Title</title>"));
  EXPECT_THAT(text, HasSubstr("<desc>x: 1 to 2,043. y: 0.8 to 14.39.</desc>"));
}

TEST(SvgPlot, a_line_breaks_where_a_value_cannot_be_shown) {
  EXPECT_EQ(count(curve(svg({.x = {1, 2, 3, 4, 5}, .y = {1, 2, nan, 4, 5}})), "M"), 2U);
  EXPECT_EQ(
      count(curve(svg({.x = {1, 2, 3, 4, 5}, .y = {1, 2, 0, 4, 5}}, linear, logarithmic)), "M"),
      2U);
}

TEST(SvgPlot, a_single_point_is_a_dot) {
  EXPECT_EQ(count(svg({.x = {1, 2, 3}, .y = {1, nan, 3}}), "<circle"), 2U);
}

TEST(SvgPlot, points_that_cannot_be_told_apart_are_drawn_as_one) {
  PlotSeries series;
  for (int i = 0; i <= 200000; ++i) {
    series.x.push_back(i);
    series.y.push_back(std::sqrt(i));
  }
  const std::string text = svg(series);
  EXPECT_LT(text.size(), 30000U);
  const PlotSeries ends{.x = {0, 200000}, .y = {0, std::sqrt(200000)}};
  EXPECT_EQ(curve(text).substr(curve(text).rfind('L')),
            curve(svg(ends)).substr(curve(svg(ends)).rfind('L')))
      << "the last point stays";
}

TEST(SvgPlot, bars_say_their_numbers_and_steps_outline_them) {
  const PlotSeries bars{.mark = Mark::bars, .x = {0, 10, 20}, .y = {5, 1500}};
  EXPECT_EQ(count(svg(bars), "<rect"), 2U);
  EXPECT_THAT(svg(bars), HasSubstr("<title>10 to 20: 1,500</title>"));
  PlotSeries steps = bars;
  steps.mark = Mark::step;
  EXPECT_EQ(count(curve(svg(steps)), "M"), 1U);
  EXPECT_EQ(count(curve(svg(steps)), "H"), 2U);
}

TEST(SvgPlot, bars_of_two_series_share_the_interval) {
  const PlotSeries bars{.mark = Mark::bars, .x = {0, 1}, .y = {1}};
  const std::string one = svg_plot({.series = {bars}});
  const std::string two = svg_plot({.series = {bars, bars}});
  const auto width = [](const std::string& text) {
    return std::stod(text.substr(text.find(" width=\"") + 8));
  };
  EXPECT_NEAR(width(two), width(one) / 2.0, 1.0);
}

TEST(SvgPlot, names_stand_beside_the_curves_without_touching) {
  const PlotSeries one{.name = "one", .x = {0, 1}, .y = {0, 5}};
  const PlotSeries two{.name = "two", .x = {0, 1}, .y = {0, 5}};
  const std::string text = svg_plot({.series = {one, two}});
  const auto y_of = [&](const std::string& name) {
    const std::size_t at = text.rfind("y=\"", text.find(">" + name + "<"));
    return std::stod(text.substr(at + 3));
  };
  EXPECT_GE(y_of("two") - y_of("one"), 12.0);
}

TEST(SvgPlot, numbers_of_any_kind_make_a_plot) {
  const std::vector<double> wild = {nan,    infinity, -infinity, 1e308, -1e308,
                                    1e-320, 0.0,      1.0,       -1.0};
  const std::vector<std::vector<double>> lists = {{}, {1.0}, {nan}, {0.0, 0.0}, wild};
  for (const AxisScale x : {linear, logarithmic}) {
    for (const AxisScale y : {linear, logarithmic}) {
      for (const Mark mark : {Mark::line, Mark::step, Mark::bars}) {
        for (const auto& xs : lists) {
          for (const auto& ys : lists) {
            const std::string text = svg({.name = "n", .mark = mark, .x = xs, .y = ys}, x, y);
            EXPECT_THAT(text, Not(HasSubstr("nan")));
            EXPECT_THAT(text, Not(HasSubstr("inf")));
          }
        }
      }
    }
  }
}

TEST(SvgPlot, says_so_where_there_is_nothing_to_show) {
  EXPECT_THAT(svg_plot({}), HasSubstr(">nothing to show<"));
  EXPECT_THAT(svg({.x = {1}, .y = {nan}}), HasSubstr(">nothing to show<"));
  EXPECT_THAT(svg({.x = {1}, .y = {1}}), Not(HasSubstr(">nothing to show<")));
}

TEST(SvgPlot, escapes_every_text) {
  const std::string text = svg_plot({.title = "<t>",
                                     .x = {"<x>"},
                                     .y = {"<y>"},
                                     .series = {{.name = "<n>", .x = {1, 2}, .y = {1, 2}}}});
  for (const char* tag : {"<t>", "<x>", "<y>", "<n>"}) {
    EXPECT_THAT(text, Not(HasSubstr(tag)));
  }
}

TEST(SvgPlot, takes_its_colours_from_the_page) {
  const std::string style(plot_style());
  EXPECT_THAT(style, HasSubstr("var(--plot-1)"));
  EXPECT_THAT(style, Not(HasSubstr("#")));
  EXPECT_THAT(svg({.x = {1, 2}, .y = {1, 2}}), Not(HasSubstr("#")));
}

}  // namespace
}  // namespace collage
