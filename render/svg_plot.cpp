#include "render/svg_plot.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "render/html_text.h"
#include "render/plot_frame.h"

namespace collage {
namespace {

constexpr double swatch_width = 16.0;
constexpr std::size_t longest_name = 18;
constexpr std::size_t style_count = 4;

using Mark = PlotSeries::Mark;

struct Point {
  double x;
  double y;
};
/// Points to connect, on the page.
using Run = std::vector<Point>;

/// One value of a histogram on the page, from the base to `end`.
struct Block {
  double left;
  double right;
  double end;
  std::string text;
};

std::string series_class(std::size_t index) {
  return fmt::format("series-{}", index % style_count + 1);
}

std::vector<Run> runs(const PlotSeries& series, const PlotFrame& frame) {
  std::vector<Run> runs(1);
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    if (can_show(frame.x_scale(), series.x[i]) && can_show(frame.y_scale(), series.y[i])) {
      runs.back().push_back({frame.x_of(series.x[i]), frame.y_of(series.y[i])});
    } else if (!runs.back().empty()) {
      runs.emplace_back();
    }
  }
  if (runs.back().empty()) {
    runs.pop_back();
  }
  return runs;
}

/// Leaves out points that cannot be told from the one before; the last one stays.
Run thinned(const Run& run) {
  constexpr double visible = 0.5;
  Run kept = {run.front()};
  for (const Point& point : run) {
    if (std::abs(point.x - kept.back().x) >= visible ||
        std::abs(point.y - kept.back().y) >= visible) {
      kept.push_back(point);
    }
  }
  if (kept.back().x != run.back().x || kept.back().y != run.back().y) {
    kept.push_back(run.back());
  }
  return kept;
}

std::vector<Block> blocks(const PlotSeries& series, const PlotFrame& frame) {
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < series.y.size() && i + 1 < series.x.size(); ++i) {
    const double from = std::min(series.x[i], series.x[i + 1]);
    const double to = std::max(series.x[i], series.x[i + 1]);
    const double value = series.y[i];
    if (can_show(frame.x_scale(), from) && can_show(frame.x_scale(), to) &&
        can_show(AxisScale::linear, value)) {
      blocks.push_back(
          {frame.x_of(from), frame.x_of(to),
           can_show(frame.y_scale(), value) ? frame.y_of(value) : frame.base(),
           fmt::format("{} to {}: {}", short_number(from), short_number(to), short_number(value))});
    }
  }
  return blocks;
}

std::string line_svg(const PlotSeries& series, const PlotFrame& frame) {
  std::string path;
  std::string dots;
  for (const Run& run : runs(series, frame)) {
    const Run points = thinned(run);
    if (points.size() == 1) {
      dots += fmt::format("<circle class=\"block\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\"/>",
                          points[0].x, points[0].y);
      continue;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      path += fmt::format("{}{:.1f} {:.1f}", i == 0 ? 'M' : 'L', points[i].x, points[i].y);
    }
  }
  return (path.empty() ? "" : "<path class=\"curve\" d=\"" + path + "\"/>") + dots;
}

std::string step_svg(const PlotSeries& series, const PlotFrame& frame) {
  const std::string to_base = fmt::format("V{:.1f}", frame.base());
  std::string path;
  double end = std::numeric_limits<double>::quiet_NaN();
  for (const Block& block : blocks(series, frame)) {
    if (block.left != end) {
      path += path.empty() ? "" : to_base;
      path += fmt::format("M{:.1f} {:.1f}", block.left, frame.base());
    }
    path += fmt::format("V{:.1f}H{:.1f}", block.end, block.right);
    end = block.right;
  }
  return path.empty() ? ""
                      : fmt::format(
                            "<path class=\"area\" d=\"{0}\"/><path class=\"curve\" "
                            "d=\"{0}\"/>",
                            path + to_base);
}

/// Each bar is the `part`th of `parts` in its interval.
std::string bars_svg(const PlotSeries& series, const PlotFrame& frame, double part, double parts) {
  std::string text;
  for (const Block& block : blocks(series, frame)) {
    const double share = (block.right - block.left) / parts;
    const double space = std::min(1.5, share / 8.0);
    text += fmt::format(
        "<rect class=\"block\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\">"
        "<title>{}</title></rect>",
        block.left + part * share + space / 2.0, std::min(block.end, frame.base()), share - space,
        std::abs(frame.base() - block.end), block.text);
  }
  return text;
}

/// "" where there is nothing to show.
std::string marks_svg(const std::vector<PlotSeries>& all, const PlotFrame& frame) {
  const auto parts = static_cast<double>(std::ranges::count(all, Mark::bars, &PlotSeries::mark));
  double part = 0.0;
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::string marks;
    if (all[i].mark == Mark::bars) {
      marks = bars_svg(all[i], frame, part, parts);
      part += 1.0;
    } else {
      marks = all[i].mark == Mark::line ? line_svg(all[i], frame) : step_svg(all[i], frame);
    }
    if (!marks.empty()) {
      text += fmt::format("<g class=\"{}\">{}</g>\n", series_class(i), marks);
    }
  }
  return text;
}

/// Where a series' name would best stand: at the end of a line, at the top of other marks.
std::optional<double> name_height(const PlotSeries& series, const PlotFrame& frame) {
  if (series.mark == Mark::line) {
    const std::vector<Run> all = runs(series, frame);
    return all.empty() ? std::nullopt : std::optional(all.back().back().y);
  }
  const std::vector<Block> all = blocks(series, frame);
  const auto highest = std::ranges::min_element(all, {}, &Block::end);
  return highest == all.end() ? std::nullopt : std::optional(highest->end);
}

struct Name {
  std::size_t series;
  double y;
};

/// From the top down, a line apart, inside the frame as long as there is room.
std::vector<Name> placed_names(const std::vector<PlotSeries>& all, const PlotFrame& frame) {
  std::vector<Name> names;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::optional<double> y = name_height(all[i], frame);
    if (y && !all[i].name.empty()) {
      names.push_back({i, *y});
    }
  }
  std::ranges::stable_sort(names, {}, &Name::y);
  double highest = PlotFrame::top;
  double lowest = PlotFrame::bottom - PlotFrame::line_height * static_cast<double>(names.size());
  for (Name& name : names) {
    lowest += PlotFrame::line_height;
    name.y = std::max(highest, std::min(name.y, lowest));
    highest = name.y + PlotFrame::line_height;
  }
  return names;
}

std::string names_svg(const std::vector<PlotSeries>& all, const PlotFrame& frame) {
  const double left = frame.right() + PlotFrame::gap;
  std::string text;
  for (const Name& name : placed_names(all, frame)) {
    text += fmt::format(
        "<g class=\"{}\"><path class=\"curve\" d=\"M{:.1f} {:.1f}h{:.1f}\"/>"
        "<text class=\"name\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text></g>\n",
        series_class(name.series), left, name.y, swatch_width, left + swatch_width + PlotFrame::gap,
        name.y + 4.0, html_text(shortened(all[name.series].name, longest_name)));
  }
  return text;
}

double names_width(const std::vector<PlotSeries>& all) {
  double widest = 0.0;
  for (const PlotSeries& series : all) {
    if (!series.name.empty()) {
      widest = std::max(widest, 2.0 * PlotFrame::gap + swatch_width +
                                    estimated_width(shortened(series.name, longest_name)));
    }
  }
  return widest;
}

/// "fill, %: 0.8 to 14.39."
std::string extent(const PlotDimension& dimension, const std::vector<PlotSeries>& all,
                   std::vector<double> PlotSeries::*values) {
  std::vector<double> shown;
  for (const PlotSeries& series : all) {
    std::ranges::copy_if(series.*values, std::back_inserter(shown),
                         [&](double value) { return can_show(dimension.scale, value); });
  }
  if (shown.empty()) {
    return html_text(dimension.label) + ": nothing to show.";
  }
  const auto [least, most] = std::ranges::minmax(shown);
  return fmt::format("{}: {} to {}.", html_text(dimension.label), short_number(least),
                     short_number(most));
}

std::string nothing_to_show(const PlotFrame& frame) {
  return fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">nothing to show</text>\n",
      (frame.left() + frame.right()) / 2.0, (PlotFrame::top + PlotFrame::bottom) / 2.0);
}

std::string base_line(const PlotFrame& frame) {
  return fmt::format("<path class=\"base\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>\n", frame.left(),
                     frame.base(), frame.right());
}

}  // namespace

std::string svg_plot(const Plot& plot) {
  const PlotFrame frame(plot, names_width(plot.series));
  const std::string marks = marks_svg(plot.series, frame);
  return fmt::format(
      "<svg class=\"plot\" viewBox=\"0 0 {} {}\" role=\"img\">\n<title>{}</title>\n"
      "<desc>{} {}</desc>\n{}{}{}{}</svg>\n",
      PlotFrame::width, PlotFrame::height, html_text(plot.title),
      extent(plot.x, plot.series, &PlotSeries::x), extent(plot.y, plot.series, &PlotSeries::y),
      frame.svg(), marks.empty() ? nothing_to_show(frame) : marks, base_line(frame),
      names_svg(plot.series, frame));
}

std::string_view plot_style() {
  return R"(.plot { display: block; width: 100%; height: auto; font-size: 12px; fill: var(--quiet); }
.plot .grid { fill: none; stroke: var(--line); stroke-width: .7; }
.plot .base { stroke: var(--quiet); stroke-width: .9; }
.plot .label { fill: currentColor; }
.plot .name { fill: var(--series); }
.plot .curve { fill: none; stroke: var(--series); stroke-width: 1.8; stroke-linejoin: round; }
.plot .area { fill: var(--series); opacity: .13; }
.plot .block { fill: var(--series); }
.plot .series-1 { --series: var(--plot-1); }
.plot .series-2 { --series: var(--plot-2); stroke-dasharray: 6 2.5; }
.plot .series-3 { --series: var(--plot-3); stroke-dasharray: 2 2; }
.plot .series-4 { --series: var(--plot-4); stroke-dasharray: 8 2 2 2; }
)";
}

}  // namespace collage
