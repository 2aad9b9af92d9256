#include "scene/scene_file.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "base/error.h"
#include "base/file.h"
#include "scene/option_check.h"
#include "scene/options_table.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t largest_file_bytes = std::uintmax_t{1} << 20;
/// toml++ limits the depth of brackets and braces, but each dot of a.a.a.a opens a table as well,
/// and its destructor recurses: some hundred thousand of them would overflow the stack.
constexpr std::ptrdiff_t most_dots = 10000;

template <class Item>
std::optional<OptionValue> list_value(const toml::array& array) {
  std::vector<Item> list;
  for (const toml::node& node : array) {
    const auto item = node.is_boolean() ? std::nullopt : node.value<Item>();
    if (!item) {
      return std::nullopt;
    }
    list.push_back(*item);
  }
  return list;
}

/// Nothing for what no option takes: dates, tables, lists of lists, mixed lists.
std::optional<OptionValue> option_value(const toml::node& node) {
  if (const auto* array = node.as_array()) {
    const auto numbers = list_value<double>(*array);
    return numbers ? numbers : list_value<std::string>(*array);
  }
  if (const auto* value = node.as_boolean()) {
    return value->get();
  }
  if (const auto* value = node.as_integer()) {
    return value->get();
  }
  if (const auto* value = node.as_floating_point()) {
    return value->get();
  }
  if (const auto* value = node.as_string()) {
    return value->get();
  }
  return std::nullopt;
}

std::string member(const std::string& table, const std::string& name) { return table + "." + name; }

int line_of(const toml::source_region& region) { return static_cast<int>(region.begin.line); }

/// Takes one parsed file over into a scene.
class Reader {
 public:
  Reader(fs::path file, const MeshLibraries& libraries)
      : file_(std::move(file)), libraries_(libraries) {}

  Scene scene(const toml::table& root) {
    for (const auto& [key, node] : root) {
      read_section(key, node);
    }
    require_target(root);
    require_elements(root);
    return std::move(scene_);
  }

 private:
  [[nodiscard]] Place at(const toml::source_region& region) const {
    return {file_, line_of(region)};
  }

  void read_section(const toml::key& key, const toml::node& node) {
    const std::string name(key.str());
    const auto& sections = option_sections();
    if (std::find(sections.begin(), sections.end(), name) == sections.end()) {
      refuse_unknown(key, "section [" + name + "]", sections);
    }
    if (name == "element") {
      read_elements(key, node);
    } else if (const auto* table = node.as_table()) {
      read_keys(name, 0, *table);
    } else {
      throw Error(at(key.source()), "'" + name + "' is a section", "write [" + name + "]");
    }
  }

  void read_elements(const toml::key& key, const toml::node& node) {
    const auto* array = node.as_array();
    const bool tables = array != nullptr && array->is_homogeneous(toml::node_type::table);
    if (!tables) {
      throw Error(at(key.source()), "'element' is a list of sections", "write [[element]]");
    }
    for (const toml::node& element : *array) {
      scene_.elements.emplace_back();
      read_keys("element", scene_.elements.size() - 1, *element.as_table());
    }
  }

  /// `section` may be a table within a section, "target.text".
  void read_keys(const std::string& section, std::size_t element, const toml::table& table) {
    for (const auto& [key, node] : table) {
      const std::string name(key.str());
      const bool plain = name.find('.') == std::string::npos;
      const std::string full_name = member(section, name);
      const Option* option = plain ? find_option(full_name) : nullptr;
      if (option != nullptr) {
        read_value(*option, element, key, node);
      } else if (plain && !names_in(full_name).empty()) {
        read_inner_table(full_name, element, key, node);
      } else {
        refuse_key(key, section);
      }
    }
  }

  void read_inner_table(const std::string& name, std::size_t element, const toml::key& key,
                        const toml::node& node) {
    const auto* table = node.as_table();
    if (table == nullptr) {
      const std::string own(key.str());
      throw Error(at(key.source()), "'" + own + "' is a table",
                  "write " + own + " = { " + names_in(name).front() + " = … }");
    }
    read_keys(name, element, *table);
  }

  void read_value(const Option& option, std::size_t element, const toml::key& key,
                  const toml::node& node) {
    const OptionSource source{at(key.source()), file_.parent_path(), OptionSource::Paths::resolve,
                              libraries_};
    const auto value = option_value(node);
    if (!value) {
      throw Error(source.place, option.full_key(element) + " is of the wrong type",
                  "use " + accepted_values(option));
    }
    option.store(scene_, element, checked(option, element, *value, source));
  }

  [[noreturn]] void refuse_key(const toml::key& key, const std::string& section) const {
    refuse_unknown(key, "key '" + std::string(key.str()) + "' in [" + section + "]",
                   names_in(section));
  }

  [[noreturn]] void refuse_unknown(const toml::key& key, const std::string& what,
                                   const std::vector<std::string>& known) const {
    std::string remedy = did_you_mean(std::string(key.str()), known);
    if (remedy.empty()) {
      remedy = "use one of";
      for (const std::string& name : known) {
        remedy += (&name == &known.front() ? " " : ", ") + name;
      }
    }
    throw Error(at(key.source()), "there is no " + what, remedy);
  }

  /// Keys and inner tables of a section or of a table in one.
  [[nodiscard]] static std::vector<std::string> names_in(const std::string& section) {
    std::vector<std::string> names;
    const std::string start = section + ".";
    for (const Option& option : options_table()) {
      if (option.key.starts_with(start)) {
        const std::string rest = option.key.substr(start.size());
        const std::string name = rest.substr(0, rest.find('.'));
        if (names.empty() || names.back() != name) {
          names.push_back(name);
        }
      }
    }
    return names;
  }

  void require_target(const toml::table& root) const {
    const auto* section = root["target"].as_table();
    if (section == nullptr) {
      throw Error({file_}, "has no target", "add [target] with mesh = \"shape.obj\"");
    }
    require_one_shape(*section, "[target]", {"mesh", "sdf", "text"});
  }

  void require_elements(const toml::table& root) const {
    if (scene_.elements.empty()) {
      throw Error({file_}, "has no element", "add [[element]] with mesh = \"shape.obj\"");
    }
    for (const toml::node& element : *root["element"].as_array()) {
      require_one_shape(*element.as_table(), "this [[element]]", {"mesh", "text"});
    }
  }

  void require_one_shape(const toml::table& section, const std::string& title,
                         std::initializer_list<std::string_view> names) const {
    std::vector<std::string_view> given;
    int line = 0;
    for (const std::string_view name : names) {
      if (const auto* node = section.get(name)) {
        given.push_back(name);
        line = std::max(line, line_of(node->source()));
      }
    }
    if (given.empty()) {
      throw Error(at(section.source()), title + " has no shape", "add mesh = \"shape.obj\"");
    }
    if (given.size() > 1) {
      throw Error({file_, line},
                  title + " has both " + std::string(given[0]) + " and " + std::string(given[1]),
                  "keep one of them");
    }
    const auto* text = section["text"].as_table();
    if (text != nullptr && !text->contains("string")) {
      throw Error({file_, line}, title + " has a text without letters",
                  "write text = { string = \"A\" }");
    }
  }

  fs::path file_;
  const MeshLibraries& libraries_;
  Scene scene_;
};

toml::table parsed(const fs::path& file) {
  const std::string content = read_file(file, largest_file_bytes);
  if (std::count(content.begin(), content.end(), '.') > most_dots) {
    throw Error({file}, "has more than 10000 dots, too many for a scene",
                "check that it is a scene file");
  }
  try {
    return toml::parse(std::string_view(content));
  } catch (const toml::parse_error& error) {
    throw Error({file, line_of(error.source())}, std::string(error.description()),
                "write it as TOML has it, https://toml.io");
  }
}

std::string name_of(const fs::path& file) {
  const fs::path folder = fs::absolute(file).lexically_normal().parent_path();
  return file.filename() == "scene.toml" && folder.has_filename() ? folder.filename().string()
                                                                  : file.stem().string();
}

}  // namespace

Scene read_scene(const fs::path& path, const MeshLibraries& libraries) {
  std::error_code ignored;  // what cannot be looked at is reported by read_file()
  const fs::path file = fs::is_directory(path, ignored) ? path / "scene.toml" : path;
  Scene scene = Reader(file, libraries).scene(parsed(file));
  scene.name = name_of(file);
  scene.file = file;
  return scene;
}

}  // namespace collage
