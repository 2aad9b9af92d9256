#pragma once

#include <algorithm>
#include <concepts>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "scene/option.h"

namespace collage {

/// Builds rows of the options table: everything that follows from the type of the field that a key
/// sets is derived here, so that a row need only name the field. For options_table.cpp alone.
namespace option_row {

inline void copy_in(bool& field, const OptionValue& value) { field = std::get<bool>(value); }
inline void copy_in(double& field, const OptionValue& value) { field = std::get<double>(value); }
inline void copy_in(std::string& field, const OptionValue& value) {
  field = std::get<std::string>(value);
}
inline void copy_in(std::filesystem::path& field, const OptionValue& value) {
  field = std::get<std::string>(value);
}
template <std::integral Whole>
void copy_in(Whole& field, const OptionValue& value) {
  field = static_cast<Whole>(std::get<std::int64_t>(value));
}
inline void copy_in(std::array<int, 2>& field, const OptionValue& value) {
  const auto& list = std::get<std::vector<double>>(value);
  field = {static_cast<int>(list.at(0)), static_cast<int>(list.at(1))};
}
template <class Item>
void copy_in(std::vector<Item>& field, const OptionValue& value) {
  field = std::get<std::vector<Item>>(value);
}

inline OptionValue copy_out(bool field) { return field; }
inline OptionValue copy_out(double field) { return field; }
inline OptionValue copy_out(const std::string& field) { return field; }
inline OptionValue copy_out(const std::filesystem::path& field) { return field.string(); }
template <std::integral Whole>
OptionValue copy_out(Whole field) {
  return static_cast<std::int64_t>(field);
}
inline OptionValue copy_out(const std::array<int, 2>& field) {
  return std::vector<double>(field.begin(), field.end());
}
template <class Item>
OptionValue copy_out(const std::vector<Item>& field) {
  return field;
}

template <class Field>
constexpr OptionKind kind_of() {
  if constexpr (std::is_same_v<Field, bool>) {
    return OptionKind::boolean;
  } else if constexpr (std::is_integral_v<Field>) {
    return OptionKind::whole_number;
  } else if constexpr (std::is_same_v<Field, double>) {
    return OptionKind::number;
  } else if constexpr (std::is_same_v<Field, std::vector<double>>) {
    return OptionKind::numbers;
  } else if constexpr (std::is_same_v<Field, std::array<int, 2>>) {
    return OptionKind::size;
  } else if constexpr (std::is_same_v<Field, std::vector<std::string>>) {
    return OptionKind::texts;
  } else {
    return OptionKind::text;
  }
}

/// A row for the field that `field(scene, element)` refers to.
template <class FieldOf>
Option row(std::string key, FieldOf field, OptionText text) {
  using Field = std::remove_cvref_t<decltype(field(std::declval<Scene&>(), 0))>;
  Option option{std::move(text), std::move(key), kind_of<Field>(), {}, {}};
  if constexpr (std::is_enum_v<Field>) {
    option.form = TextForm::word;
    option.store = [field, words = option.words](Scene& scene, std::size_t k,
                                                 const OptionValue& v) {
      const auto word = std::find(words.begin(), words.end(), std::get<std::string>(v));
      field(scene, k) = static_cast<Field>(word - words.begin());
    };
    option.load = [field, words = option.words](const Scene& scene, std::size_t k) -> OptionValue {
      return words.at(static_cast<std::size_t>(field(scene, k)));
    };
  } else {
    option.store = [field](Scene& scene, std::size_t k, const OptionValue& value) {
      copy_in(field(scene, k), value);
    };
    option.load = [field](const Scene& scene, std::size_t k) { return copy_out(field(scene, k)); };
  }
  return option;
}

template <class FieldOf>
Option option(std::string key, FieldOf field, OptionText text) {
  return row(
      std::move(key), [field](auto& scene, std::size_t) -> auto& { return field(scene); },
      std::move(text));
}

template <class FieldOf>
Option element_option(std::string key, FieldOf field, OptionText text) {
  return row(
      std::move(key),
      [field](auto& scene, std::size_t k) -> auto& { return field(scene.elements[k]); },
      std::move(text));
}

}  // namespace option_row
}  // namespace collage
