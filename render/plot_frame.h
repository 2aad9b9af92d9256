#pragma once

#include <string>
#include <string_view>

#include "render/svg_plot.h"

namespace collage {

/// The axes of a plot: where its numbers are on the page, and the grid with its ticks and labels.
/// Lengths are in units of the view box, letters are 12 high.
class PlotFrame {
 public:
  static constexpr double width = 440.0;
  static constexpr double height = 280.0;
  static constexpr double top = 30.0;
  static constexpr double bottom = height - 44.0;
  static constexpr double line_height = 15.0;
  static constexpr double gap = 6.0;

  /// Leaves `margin` free on the right.
  PlotFrame(const Plot& plot, double margin);

  /// For numbers that can be shown.
  [[nodiscard]] double x_of(double value) const;
  [[nodiscard]] double y_of(double value) const;
  /// Where steps and bars rise from.
  [[nodiscard]] double base() const;
  [[nodiscard]] double left() const { return left_; }
  [[nodiscard]] double right() const { return right_; }
  [[nodiscard]] AxisScale x_scale() const { return x_scale_; }
  [[nodiscard]] AxisScale y_scale() const { return y_scale_; }

  /// Grid, ticks and labels.
  [[nodiscard]] std::string svg() const;

 private:
  std::string x_label_;
  std::string y_label_;
  AxisScale x_scale_;
  AxisScale y_scale_;
  PlotAxis y_;
  PlotAxis x_;
  double left_;
  double right_;
};

/// Of a line of text; most fonts stay below.
double estimated_width(std::string_view text);

/// The text, or its start with "…" behind it, at most `letters` long. UTF-8.
std::string shortened(std::string_view text, std::size_t letters);

}  // namespace collage
