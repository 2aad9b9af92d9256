#include "scene/json_text.h"

#include <vector>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/text.h"

namespace collage {
namespace {

template <class Item>
std::string list_text(const std::vector<Item>& list) {
  std::string text;
  for (const Item& item : list) {
    text += (text.empty() ? "" : ", ") + json_text(OptionValue(item));
  }
  return "[" + text + "]";
}

struct ToJson {
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(double value) const { return number_text(value); }
  std::string operator()(const std::string& value) const { return json_text(value); }
  template <class Item>
  std::string operator()(const std::vector<Item>& value) const {
    return list_text(value);
  }
};

}  // namespace

std::string json_text(const std::string& text) {
  try {
    return nlohmann::json(text).dump(-1, ' ', true);
  } catch (const nlohmann::json::exception&) {
    throw Error("the name '" + text + "' is not UTF-8", "rename the file");
  }
}

std::string json_text(const OptionValue& value) { return std::visit(ToJson{}, value); }

std::string stopped_members(const std::optional<std::string>& stopped) {
  return stopped ? ",\n  \"complete\": false,\n  \"stopped\": " + json_text(*stopped) : "";
}

}  // namespace collage
