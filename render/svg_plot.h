#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "render/plot_axis.h"

namespace collage {

struct PlotSeries {
  enum class Mark {
    line,  // through the points; broken where a value cannot be shown
    step,  // the outline of a histogram; good for comparing several
    bars,  // a histogram; bars of several series share each interval
  };
  /// Written beside the curve; "": nothing.
  std::string name{};
  Mark mark = Mark::line;
  /// A line's points; of the others the edges of the intervals, one more than there are values.
  std::vector<double> x{};
  std::vector<double> y{};
};

struct PlotDimension {
  /// With the unit: "fill, %".
  std::string label{};
  AxisScale scale = AxisScale::linear;
};

/// Steps and bars rise from 0, or from the lower end of a logarithmic axis; a linear y axis always
/// contains 0.
struct Plot {
  /// What there is to see, for those who cannot see it and for a caption.
  std::string title{};
  PlotDimension x{};
  PlotDimension y{};
  std::vector<PlotSeries> series{};
};

/// The plot as an inline <svg> of HTML. Any numbers will do: what is not finite, or has no place on
/// a logarithmic axis, is left out, and without anything to show there are only the axes. Points
/// nearer to one another than can be seen are drawn as one. Colours, letters and lines are those of
/// plot_style(). Equal input gives equal text. Cost: O(points).
std::string svg_plot(const Plot& plot);

/// The style sheet of all plots of a page. It follows the page's custom properties --page (the
/// background), --quiet (letters), --line (grid) and --plot-1 to --plot-4 (series in turn).
std::string_view plot_style();

}  // namespace collage
