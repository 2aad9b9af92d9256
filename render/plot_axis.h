#pragma once

#include <string>
#include <vector>

namespace collage {

enum class AxisScale { linear, logarithmic };

/// Whether an axis has a place for the value: finite and no larger than 1e100; above 1e-100 on a
/// logarithmic axis.
bool can_show(AxisScale scale, double value);

/// The axis begins and ends with the data, or at the nearest 1, 2 or 5 · 10ⁿ that enclose it.
enum class AxisEnds { at_data, at_round_numbers };

/// One axis of a plot, without its place on the page.
class PlotAxis {
 public:
  struct Tick {
    double value;
    /// "2,000", "−0.05", "10⁻⁶".
    std::string text;
  };

  /// Spans those of `values` that it can show: [0, 1] (logarithmic [1, 10]) where there are none,
  /// and some room around a single one. Ticks are at round numbers, no more than `max_ticks` (≥ 3)
  /// of them; a long logarithmic axis counts in decades.
  PlotAxis(AxisScale scale, AxisEnds ends, const std::vector<double>& values, int max_ticks);

  [[nodiscard]] double from() const { return from_; }
  [[nodiscard]] double to() const { return to_; }
  [[nodiscard]] const std::vector<Tick>& ticks() const { return ticks_; }
  /// 0 at from(), 1 at to(). `value` must be one that can be shown.
  [[nodiscard]] double fraction(double value) const;

 private:
  AxisScale scale_;
  double from_;
  double to_;
  std::vector<Tick> ticks_;
};

/// A number for people: "2,043", "14.39", "−3.2×10⁻⁶"; to four significant digits, whole numbers
/// below 10⁷ in full. "–" where it is not finite.
std::string short_number(double value);

}  // namespace collage
