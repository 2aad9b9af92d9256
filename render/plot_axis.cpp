#include "render/plot_axis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace collage {
namespace {

constexpr double slack = 1e-9;
constexpr double smallest_shown = 1e-100;
constexpr double largest_shown = 1e100;
constexpr double largest_in_full = 1e7;

int floor_div(int a, int b) { return a / b - (a % b < 0 ? 1 : 0); }

double power_of_ten(int exponent) { return std::pow(10.0, exponent); }

/// All round numbers by an index: …, 0.5, 1 (index 0), 2, 5, 10, …
double round_number(int index) {
  constexpr std::array<double, 3> digits = {1.0, 2.0, 5.0};
  const int exponent = floor_div(index, 3);
  return digits.at(static_cast<std::size_t>(index - 3 * exponent)) * power_of_ten(exponent);
}

/// The largest round number that is at most `value`, which is above 0.
int round_down(double value) {
  int index = 3 * static_cast<int>(std::floor(std::log10(value))) - 1;
  while (round_number(index + 1) <= value * (1.0 + slack)) {
    ++index;
  }
  return index;
}

int round_up(double value) {
  const int index = round_down(value);
  return round_number(index) < value * (1.0 - slack) ? index + 1 : index;
}

/// Of the first digit: 3 for 2,043.
int exponent_of(double value) { return floor_div(round_down(std::abs(value)), 3); }

std::string superscript(int number) {
  constexpr std::array<std::string_view, 10> digits = {"⁰", "¹", "²", "³", "⁴",
                                                       "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char c : std::to_string(number)) {
    text += c == '-' ? "⁻" : digits.at(static_cast<std::size_t>(c - '0'));
  }
  return text;
}

/// "-1234.5" as "−1,234.5".
std::string for_people(std::string_view number) {
  const bool is_negative = number.starts_with('-');
  std::string text(number.substr(is_negative ? 1 : 0));
  const std::size_t whole = std::min(text.find('.'), text.size());
  for (int at = static_cast<int>(whole) - 3; at > 0; at -= 3) {
    text.insert(static_cast<std::size_t>(at), ",");
  }
  return (is_negative ? "−" : "") + text;
}

std::string decimal_text(double value, int decimals) {
  return for_people(fmt::format("{:.{}f}", value, decimals));
}

/// "2.5×10⁷", "10⁶".
std::string power_text(std::string_view scientific) {
  const std::size_t e = scientific.find('e');
  const std::string_view mantissa = scientific.substr(0, e);
  const std::string power = "10" + superscript(std::stoi(std::string(scientific.substr(e + 1))));
  if (mantissa == "1" || mantissa == "-1") {
    return (mantissa == "1" ? "" : "−") + power;
  }
  return for_people(mantissa) + "×" + power;
}

struct Range {
  double from = std::numeric_limits<double>::infinity();
  double to = -std::numeric_limits<double>::infinity();

  [[nodiscard]] bool is_empty() const { return from > to; }
};

struct Layout {
  Range range;
  std::vector<PlotAxis::Tick> ticks;
};

/// Of the values that can be shown.
Range range_of(AxisScale scale, const std::vector<double>& values) {
  Range range;
  for (const double value : values) {
    if (can_show(scale, value)) {
      range = {std::min(range.from, value), std::max(range.to, value)};
    }
  }
  return range;
}

/// Something to divide by: room around a single value.
Range widened(const Range& range) {
  const double size = std::max(std::abs(range.from), std::abs(range.to));
  if (range.is_empty() || size < smallest_shown) {
    return {0.0, 1.0};
  }
  if (range.to - range.from < slack * size) {
    return {range.from - size / 2.0, range.to + size / 2.0};
  }
  return range;
}

struct Steps {
  double size = 0.0;
  long long first = 0;
  long long last = 0;
  int exponent = 0;
};

Steps linear_steps(const Range& range, AxisEnds ends, int max_ticks) {
  Steps steps;
  int index = round_down((range.to - range.from) / max_ticks);
  do {
    steps.size = round_number(index);
    steps.exponent = floor_div(index, 3);
    const double first = range.from / steps.size;
    const double last = range.to / steps.size;
    const bool is_round = ends == AxisEnds::at_round_numbers;
    steps.first = std::llround(is_round ? std::floor(first + slack) : std::ceil(first - slack));
    steps.last = std::llround(is_round ? std::ceil(last - slack) : std::floor(last + slack));
    ++index;
  } while (steps.last - steps.first >= max_ticks);
  return steps;
}

std::vector<PlotAxis::Tick> linear_ticks(const Steps& steps) {
  const double largest =
      static_cast<double>(std::max(std::abs(steps.first), std::abs(steps.last))) * steps.size;
  const bool in_full = largest >= 1e-3 && largest < largest_in_full;
  std::vector<PlotAxis::Tick> ticks;
  for (long long i = steps.first; i <= steps.last; ++i) {
    const double value = static_cast<double>(i) * steps.size;
    if (in_full || i == 0) {
      ticks.push_back({value, decimal_text(value, i == 0 ? 0 : std::max(0, -steps.exponent))});
    } else {
      const int decimals = std::max(0, exponent_of(value) - steps.exponent);
      ticks.push_back({value, power_text(fmt::format("{:.{}e}", value, decimals))});
    }
  }
  return ticks;
}

/// The indices of the round numbers at the ticks from `first` to `last`.
std::vector<int> logarithmic_indices(int first, int last, int max_ticks) {
  std::vector<int> indices;
  for (int stride = 1;; stride = stride == 1 ? 3 : stride + 3) {
    indices.clear();
    for (int i = -floor_div(-first, stride) * stride; i <= last; i += stride) {
      indices.push_back(i);
    }
    if (indices.size() <= static_cast<std::size_t>(max_ticks)) {
      return indices;
    }
  }
}

std::vector<PlotAxis::Tick> logarithmic_ticks(int first, int last, int max_ticks) {
  const bool in_full = round_number(first) >= 1e-4 && round_number(last) < largest_in_full;
  std::vector<PlotAxis::Tick> ticks;
  for (const int index : logarithmic_indices(first, last, max_ticks)) {
    const double value = round_number(index);
    ticks.push_back({value, in_full ? decimal_text(value, std::max(0, -floor_div(index, 3)))
                                    : power_text(fmt::format("{:.0e}", value))});
  }
  return ticks;
}

Layout linear_layout(const Range& values, AxisEnds ends, int max_ticks) {
  const Range range = widened(values);
  std::vector<PlotAxis::Tick> ticks = linear_ticks(linear_steps(range, ends, max_ticks));
  const bool is_round = ends == AxisEnds::at_round_numbers;
  return {is_round ? Range{ticks.front().value, ticks.back().value} : range, std::move(ticks)};
}

Layout logarithmic_layout(const Range& values, AxisEnds ends, int max_ticks) {
  const Range range = values.is_empty() ? Range{1.0, 10.0} : values;
  int first = round_up(range.from);
  int last = round_down(range.to);
  if (ends == AxisEnds::at_data && first < last) {
    return {range, logarithmic_ticks(first, last, max_ticks)};
  }
  first = round_down(range.from);
  last = round_up(range.to);
  if (first == last) {
    --first;
    ++last;
  }
  return {{round_number(first), round_number(last)}, logarithmic_ticks(first, last, max_ticks)};
}

}  // namespace

bool can_show(AxisScale scale, double value) {
  return std::isfinite(value) && std::abs(value) <= largest_shown &&
         (scale == AxisScale::linear || value >= smallest_shown);
}

PlotAxis::PlotAxis(AxisScale scale, AxisEnds ends, const std::vector<double>& values, int max_ticks)
    : scale_(scale) {
  const Range range = range_of(scale, values);
  Layout layout = scale == AxisScale::linear ? linear_layout(range, ends, max_ticks)
                                             : logarithmic_layout(range, ends, max_ticks);
  from_ = layout.range.from;
  to_ = layout.range.to;
  ticks_ = std::move(layout.ticks);
}

double PlotAxis::fraction(double value) const {
  return scale_ == AxisScale::linear ? (value - from_) / (to_ - from_)
                                     : std::log(value / from_) / std::log(to_ / from_);
}

std::string short_number(double value) {
  if (!std::isfinite(value)) {
    return "–";
  }
  const double size = std::abs(value);
  if (size >= 1000.0 && size < largest_in_full) {
    return decimal_text(value, 0);
  }
  const std::string text = fmt::format("{:.4g}", value);
  return text.find('e') == std::string::npos ? for_people(text) : power_text(text);
}

}  // namespace collage
