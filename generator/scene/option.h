#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "scene/scene.h"

namespace collage {

/// A value as scene files, the command line and sculpture.json carry it. A list without entries is
/// a list of numbers.
using OptionValue = std::variant<bool, std::int64_t, double, std::string, std::vector<double>,
                                 std::vector<std::string>>;

/// How a value is written; follows from the type of the field that it goes to.
enum class OptionKind { boolean, whole_number, number, text, numbers, size, texts };

/// What a text may be: anything, one of Option::words, a file, "#rrggbb", a template (one of
/// Option::words or a .inc file), a view (one of Option::words or "azimuth/elevation"), anything
/// but nothing, or a font (a file or a name that find_font() takes).
enum class TextForm { any, word, path, color, look, view, letters, font };

/// What the table says on a key beside its field.
struct OptionText {
  /// Inclusive; for numbers of every kind.
  double minimum = 0.0;
  double maximum = 0.0;
  /// Continues "a number from 0 to 1, …"; empty where there is none.
  std::string unit{};
  /// One line, without a full stop.
  std::string help{};
  TextForm form = TextForm::any;
  /// For an enumeration in the order of its enumerators.
  std::vector<std::string> words{};
  /// Lists only: the least number of entries.
  std::size_t least_count = 0;
};

/// One row of the options table.
struct Option : OptionText {
  /// "section.name". Keys of the section "element" exist once an element.
  std::string key;
  OptionKind kind = OptionKind::text;
  /// Copies a value that checked() has passed into the scene, or out of it. `element` counts for
  /// keys of elements only and must be the index of one.
  std::function<void(Scene&, std::size_t element, const OptionValue&)> store;
  std::function<OptionValue(const Scene&, std::size_t element)> load;

  [[nodiscard]] std::string section() const { return key.substr(0, key.find('.')); }
  [[nodiscard]] std::string name() const { return key.substr(key.find('.') + 1); }
  [[nodiscard]] bool of_element() const { return section() == "element"; }
  /// The key as `--set` and messages have it: "element.0.color".
  [[nodiscard]] std::string full_key(std::size_t element) const;
};

/// What the option takes, as a part of a sentence: "a number from 0.0001 to 1, a fraction of the
/// target's longest side".
std::string accepted_values(const Option& option);

/// As scene files and messages show it: 0.02, "studio", [1, 0.7].
std::string shown(const OptionValue& value);

}  // namespace collage
