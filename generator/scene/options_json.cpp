#include "scene/options_json.h"

#include <optional>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "scene/json_reader.h"
#include "scene/json_text.h"
#include "scene/option_check.h"
#include "scene/options_table.h"

namespace collage {
namespace {

using json_reader::json;
using json_reader::Problem;
using json_reader::within;

std::string section_text(const Scene& scene, const std::string& section, std::size_t element) {
  std::string text;
  for (const Option& option : options_table()) {
    if (option.section() == section) {
      text += (text.empty() ? "" : ", ") + json_text(option.name()) + ": " +
              json_text(option.load(scene, element));
    }
  }
  return "{" + text + "}";
}

std::string elements_text(const Scene& scene) {
  std::string text;
  for (std::size_t k = 0; k < scene.elements.size(); ++k) {
    text += (k == 0 ? "\n      " : ",\n      ") + section_text(scene, "element", k);
  }
  return "[" + text + "\n    ]";
}

template <class Item>
std::optional<OptionValue> list_value(const json& array) {
  try {
    return array.get<std::vector<Item>>();
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

OptionValue option_value(const json& value) {
  std::optional<OptionValue> result;
  if (value.is_boolean()) {
    result = value.get<bool>();
  } else if (value.is_number_integer()) {
    result = value.get<std::int64_t>();
  } else if (value.is_number()) {
    result = value.get<double>();
  } else if (value.is_string()) {
    result = value.get<std::string>();
  } else if (value.is_array()) {
    result = list_value<double>(value);
    result = result ? result : list_value<std::string>(value);
  }
  return result ? *result : throw Problem{"", "is of the wrong type"};
}

void read_option(Scene& scene, const std::string& key, std::size_t element, const json& value) {
  const Option* option = find_option(key);
  if (option == nullptr) {
    throw Problem{"", "is not an option"};
  }
  const OptionValue given = option_value(value);
  if (given == OptionValue(std::string())) {
    return;  // not set
  }
  const OptionSource source{{}, {}, OptionSource::Paths::keep};
  try {
    option->store(scene, element, checked(*option, element, given, source));
  } catch (const Error& error) {
    throw Problem{"", std::string("is not accepted: ") + error.what()};
  }
}

void read_section(Scene& scene, const std::string& section, std::size_t element,
                  const json& value) {
  if (!value.is_object()) {
    throw Problem{"", "is not an object"};
  }
  for (const auto& item : value.items()) {
    within(value, item.key().c_str(), [&](const json& given) {
      read_option(scene, section + "." + item.key(), element, given);
    });
  }
}

}  // namespace

std::string options_json(const Scene& scene) {
  std::string text;
  for (const std::string& section : option_sections()) {
    text += (text.empty() ? "\n    " : ",\n    ") + json_text(section) + ": " +
            (section == "element" ? elements_text(scene) : section_text(scene, section, 0));
  }
  return "{" + text + "\n  }";
}

Scene options_from_json(const json& value) {
  Scene scene;
  for (const std::string& section : option_sections()) {
    within(value, section.c_str(), [&](const json& given) {
      if (section != "element") {
        return read_section(scene, section, 0, given);
      }
      json_reader::for_each_item(given, [&](const json& item) {
        scene.elements.emplace_back();
        read_section(scene, section, scene.elements.size() - 1, item);
      });
    });
  }
  return scene;
}

}  // namespace collage
