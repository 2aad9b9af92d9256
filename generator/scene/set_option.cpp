#include "scene/set_option.h"

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

#include "scene/option_check.h"
#include "scene/options_table.h"

namespace collage {
namespace {

/// A key as the command line names it.
struct Key {
  const Option& option;
  std::size_t element;
};

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string_view::npos
             ? std::string_view{}
             : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// Without the marks round it, if it has them: [1, 2] or "word".
std::string_view without(std::string_view text, char open, char close) {
  text = trimmed(text);
  const bool enclosed = text.size() >= 2 && text.front() == open && text.back() == close;
  return enclosed ? text.substr(1, text.size() - 2) : text;
}

template <class Number>
std::optional<Number> parsed(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool complete = error == std::errc{} && end == text.data() + text.size();
  return complete ? std::optional<Number>(value) : std::nullopt;
}

std::vector<std::string> items(std::string_view text) {
  std::vector<std::string> list;
  text = without(text, '[', ']');
  while (!text.empty()) {
    const std::size_t comma = text.find(',');
    list.emplace_back(without(text.substr(0, comma), '"', '"'));
    text = comma == std::string_view::npos ? std::string_view{} : text.substr(comma + 1);
  }
  return list;
}

OptionValue number_or_text(std::string_view text) {
  if (const auto whole = parsed<std::int64_t>(text)) {
    return *whole;
  }
  const auto number = parsed<double>(text);
  return number ? OptionValue(*number) : OptionValue(std::string(text));
}

OptionValue numbers_or_text(std::string_view text) {
  std::vector<double> numbers;
  for (const std::string& item : items(text)) {
    const auto number = parsed<double>(item);
    if (!number) {
      return std::string(text);
    }
    numbers.push_back(*number);
  }
  return numbers;
}

/// What cannot be read as the option's kind stays text, which checked() then refuses.
OptionValue parsed_value(const Option& option, std::string_view text) {
  switch (option.kind) {
    case OptionKind::boolean:
      return text == "true" || text == "false" ? OptionValue(text == "true")
                                               : OptionValue(std::string(text));
    case OptionKind::whole_number:
    case OptionKind::number:
      return number_or_text(text);
    case OptionKind::numbers:
    case OptionKind::size:
      return numbers_or_text(text);
    case OptionKind::texts:
      return items(text);
    case OptionKind::text:
      break;
  }
  return std::string(without(text, '"', '"'));
}

const Option& known_option(const std::string& key, const std::string& as_written) {
  const Option* option = find_option(key);
  if (option != nullptr) {
    return *option;
  }
  std::vector<std::string> keys;
  for (const Option& candidate : options_table()) {
    keys.push_back(candidate.key);
  }
  const std::string guess = did_you_mean(key, keys);
  throw Error(
      "there is no option '" + as_written + "'",
      guess.empty() ? "write --set section.key=value, as in --set packing.threshold=0.01" : guess);
}

/// "element.0.color" is the key "element.color" of element 0.
Key parsed_key(const Scene& scene, const std::string& text) {
  constexpr std::string_view prefix = "element.";
  if (!text.starts_with(prefix)) {
    return {known_option(text, text), 0};
  }
  const std::string_view rest = std::string_view(text).substr(prefix.size());
  const std::size_t dot = rest.find('.');
  const auto element = parsed<std::size_t>(rest.substr(0, dot));
  if (!element || dot == std::string_view::npos || *element >= scene.elements.size()) {
    throw Error("'" + text + "' does not name an element of the scene",
                "write element.0. for the first, up to element." +
                    std::to_string(scene.elements.size() - 1) + ". for the last");
  }
  return {known_option("element." + std::string(rest.substr(dot + 1)), text), *element};
}

/// A target or an element has one shape: the one that was set last.
void leave_one_shape(Scene& scene, const std::string& key, std::size_t element) {
  if (key == "target.mesh") {
    scene.target.sdf.clear();
    scene.target.text.string.clear();
  } else if (key == "target.sdf") {
    scene.target.mesh.clear();
    scene.target.text.string.clear();
  } else if (key == "target.text.string") {
    scene.target.mesh.clear();
    scene.target.sdf.clear();
  } else if (key == "element.mesh") {
    scene.elements[element].text.string.clear();
  } else if (key == "element.text.string") {
    scene.elements[element].mesh.clear();
  }
}

}  // namespace

void set_option(Scene& scene, const std::string& assignment, const MeshLibraries& libraries) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos) {
    throw Error("'" + assignment + "' sets nothing",
                "write section.key=value, as in packing.threshold=0.01");
  }
  const auto [option, element] =
      parsed_key(scene, std::string(trimmed(assignment.substr(0, equals))));
  const OptionValue value =
      parsed_value(option, trimmed(std::string_view(assignment).substr(equals + 1)));
  const OptionSource command_line{
      {}, std::filesystem::current_path(), OptionSource::Paths::resolve, libraries};
  option.store(scene, element, checked(option, element, value, command_line));
  leave_one_shape(scene, option.key, element);
}

}  // namespace collage
