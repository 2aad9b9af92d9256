#include "scene/option.h"

#include <array>
#include <charconv>
#include <cmath>

#include "base/text.h"

namespace collage {
namespace {

/// As people write it, 0.0001 and not 1e-04.
std::string shown_item(double number) {
  if (!std::isfinite(number)) {
    return std::isnan(number) ? "nan" : number < 0 ? "-inf" : "inf";
  }
  const double size = std::abs(number);
  if (size != 0.0 && (size < 1e-9 || size > 1e16)) {
    return number_text(number);
  }
  std::array<char, 64> digits;
  const auto end = std::to_chars(digits.begin(), digits.end(), number, std::chars_format::fixed);
  return {digits.data(), end.ptr};
}
std::string shown_item(const std::string& text) { return '"' + text + '"'; }

template <class Item>
std::string shown_list(const std::vector<Item>& items) {
  std::string text;
  for (const Item& item : items) {
    text += (text.empty() ? "" : ", ") + shown_item(item);
  }
  return "[" + text + "]";
}

struct Shower {
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(double value) const { return shown_item(value); }
  std::string operator()(const std::string& value) const { return shown_item(value); }
  template <class Item>
  std::string operator()(const std::vector<Item>& value) const {
    return shown_list(value);
  }
};

/// "a", "b" or "c".
std::string alternatives(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += i == 0 ? "" : i + 1 == words.size() ? " or " : ", ";
    text += shown_item(words[i]);
  }
  return text;
}

std::string accepted_text(const Option& option) {
  switch (option.form) {
    case TextForm::any:
      return "text";
    case TextForm::word:
      return alternatives(option.words);
    case TextForm::path:
      return "the path of a file";
    case TextForm::color:
      return "a colour as \"#rrggbb\"";
    case TextForm::look:
      return alternatives(option.words) + ", or the path of a template ending in .inc";
    case TextForm::view:
      return alternatives(option.words) + ", or \"azimuth/elevation\" in degrees";
    case TextForm::letters:
      return "one or more characters";
    case TextForm::font:
      return "a font as \"DejaVu Sans:bold\", or the path of a .ttf or .otf file";
  }
  return {};
}

std::string accepted_kind(const Option& option) {
  const std::string range =
      " from " + shown_item(option.minimum) + " to " + shown_item(option.maximum);
  switch (option.kind) {
    case OptionKind::boolean:
      return "true or false";
    case OptionKind::whole_number:
      return "a whole number" + range;
    case OptionKind::number:
      return "a number" + range;
    case OptionKind::numbers:
      return "a list of numbers" + range;
    case OptionKind::size:
      return "a list of two whole numbers" + range;
    case OptionKind::text:
      return accepted_text(option);
    case OptionKind::texts:
      return "a list of " +
             (option.form == TextForm::path ? "paths of files" : accepted_text(option));
  }
  return {};
}

}  // namespace

std::string Option::full_key(std::size_t element) const {
  return of_element() ? "element." + std::to_string(element) + "." + name() : key;
}

std::string accepted_values(const Option& option) {
  return accepted_kind(option) + (option.unit.empty() ? "" : ", " + option.unit);
}

std::string shown(const OptionValue& value) { return std::visit(Shower{}, value); }

}  // namespace collage
