#include "render/plot_frame.h"

#include <algorithm>

#include <fmt/format.h>

#include "render/html_text.h"

namespace collage {
namespace {

constexpr double letter_width = 8.0;  // in a wide font
constexpr std::size_t longest_label = 48;

bool is_continued(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80; }

PlotAxis y_axis(const Plot& plot) {
  std::vector<double> values;
  for (const PlotSeries& series : plot.series) {
    for (const double value : series.y) {
      values.push_back(value);
      if (plot.y.scale == AxisScale::logarithmic && series.mark != PlotSeries::Mark::line) {
        values.push_back(value / 1.5);  // else the smallest would be a bar without height
      }
    }
  }
  if (plot.y.scale == AxisScale::linear) {
    values.push_back(0.0);
  }
  return {plot.y.scale, AxisEnds::at_round_numbers, values, 6};
}

double widest_tick(const PlotAxis& axis) {
  double widest = 0.0;
  for (const PlotAxis::Tick& tick : axis.ticks()) {
    widest = std::max(widest, estimated_width(tick.text));
  }
  return widest;
}

/// With as many ticks as there is room for.
PlotAxis x_axis(const Plot& plot, double room) {
  std::vector<double> values;
  for (const PlotSeries& series : plot.series) {
    values.insert(values.end(), series.x.begin(), series.x.end());
  }
  constexpr int fewest_ticks = 3;
  for (int max_ticks = 7;; --max_ticks) {
    PlotAxis axis(plot.x.scale, AxisEnds::at_data, values, max_ticks);
    const double needed =
        static_cast<double>(axis.ticks().size()) * (widest_tick(axis) + letter_width);
    if (max_ticks == fewest_ticks || needed <= room) {
      return axis;
    }
  }
}

}  // namespace

PlotFrame::PlotFrame(const Plot& plot, double margin)
    : x_label_(shortened(plot.x.label, longest_label)),
      y_label_(shortened(plot.y.label, longest_label)),
      x_scale_(plot.x.scale),
      y_scale_(plot.y.scale),
      y_(y_axis(plot)),
      x_(x_axis(plot, width - widest_tick(y_) - margin)),
      left_(std::max(widest_tick(y_) + gap, widest_tick(x_) / 2.0)),
      right_(width - std::max({margin, widest_tick(x_) / 2.0, gap})) {}

double PlotFrame::x_of(double value) const { return left_ + x_.fraction(value) * (right_ - left_); }

double PlotFrame::y_of(double value) const { return bottom - y_.fraction(value) * (bottom - top); }

double PlotFrame::base() const { return y_scale_ == AxisScale::linear ? y_of(0.0) : bottom; }

std::string PlotFrame::svg() const {
  std::string grid;
  std::string x_texts;
  std::string y_texts;
  for (const PlotAxis::Tick& tick : x_.ticks()) {
    const double x = x_of(tick.value);
    grid += fmt::format("M{:.1f} {:.1f}V{:.1f}", x, top, bottom);
    x_texts += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", x,
                           bottom + line_height + 2.0, tick.text);
  }
  for (const PlotAxis::Tick& tick : y_.ticks()) {
    const double y = y_of(tick.value);
    grid += fmt::format("M{:.1f} {:.1f}H{:.1f}", left_, y, right_);
    y_texts +=
        fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", left_ - gap, y + 4.0, tick.text);
  }
  return fmt::format(
      "<path class=\"grid\" d=\"{}\"/>\n"
      "<g text-anchor=\"middle\">{}</g>\n<g text-anchor=\"end\">{}</g>\n"
      "<text class=\"label\" x=\"0\" y=\"13\">{}</text>\n"
      "<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n",
      grid, x_texts, y_texts, html_text(y_label_), right_, height - 6.0, html_text(x_label_));
}

double estimated_width(std::string_view text) {
  return letter_width *
         static_cast<double>(std::ranges::count_if(text, [](char c) { return !is_continued(c); }));
}

std::string shortened(std::string_view text, std::size_t letters) {
  std::size_t count = 0;
  std::size_t last = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (is_continued(text[i])) {
      continue;
    }
    if (++count == letters) {
      last = i;
    } else if (count > letters) {
      return std::string(text.substr(0, last)) + "…";
    }
  }
  return std::string(text);
}

}  // namespace collage
