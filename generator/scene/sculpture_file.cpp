#include "scene/sculpture_file.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/file.h"
#include "base/text.h"
#include "geometry/font_file.h"
#include "scene/credit_json.h"
#include "scene/instance_lines.h"
#include "scene/json_reader.h"
#include "scene/json_text.h"
#include "scene/options_json.h"

namespace collage {
namespace {

using json_reader::for_each_item;
using json_reader::json;
using json_reader::natural;
using json_reader::number;
using json_reader::positive;
using json_reader::Problem;
using json_reader::text;
using json_reader::within;
namespace fs = std::filesystem;

/// A font without its folder, which is nothing to others.
void forget_folder(LetterOptions& letters) {
  if (is_font_path(letters.font)) {
    letters.font = fs::path(letters.font).filename().string();
  }
}

/// The options as they are in the finished folder: inputs and template are the copies in it.
/// Letters stay letters; their meshes are the inputs.
Scene with_copies(const Sculpture& sculpture) {
  Scene scene = sculpture.options;
  if (scene.target.text.string.empty()) {
    (scene.target.mesh.empty() ? scene.target.sdf : scene.target.mesh) = sculpture.target.path;
  }
  forget_folder(scene.target.text);
  for (std::size_t k = 0; k < scene.elements.size(); ++k) {
    Scene::Element& element = scene.elements[k];
    element.mesh = element.text.string.empty() ? sculpture.elements.at(k).path : fs::path();
    forget_folder(element.text);
  }
  scene.render.props.clear();
  for (const Sculpture::Input& prop : sculpture.props) {
    scene.render.props.push_back(prop.path.generic_string());
  }
  scene.render.look = std::filesystem::path(scene.render.look).filename().string();
  return scene;
}

std::string input_members(const Sculpture::Input& input) {
  return "\"path\": " + json_text(input.path.generic_string()) +
         ", \"sha256\": " + json_text(input.sha256) +
         (input.credit ? ", \"credit\": " + credit_json(*input.credit) : "");
}

std::string inputs_text(const Sculpture& sculpture) {
  std::string text = "  \"target\": {" + input_members(sculpture.target) + "},\n  \"elements\": [";
  std::string_view separator = "\n    ";
  for (const Sculpture::Element& element : sculpture.elements) {
    text.append(separator);
    text += "{\"name\": " + json_text(element.name) + ", " + input_members(element) +
            ", \"size\": " + number_text(element.size) + "}";
    separator = ",\n    ";
  }
  if (!sculpture.props.empty()) {
    text += "\n  ],\n  \"props\": [";
    separator = "\n    ";
    for (const Sculpture::Input& prop : sculpture.props) {
      text.append(separator);
      text += "{" + input_members(prop) + "}";
      separator = ",\n    ";
    }
  }
  return text + "\n  ],\n";
}

/// A path that stays in the folder, whatever the file says.
fs::path inner_path(const json& value) {
  fs::path path = fs::path(text(value)).lexically_normal();
  if (path.empty() || path.is_absolute() || *path.begin() == "..") {
    throw Problem{"", "is not a path inside the folder"};
  }
  return path;
}

std::string digest(const json& value) {
  std::string result = text(value);
  if (result.size() != 64 || result.find_first_not_of("0123456789abcdef") != std::string::npos) {
    throw Problem{"", "is not a SHA-256 of 64 hexadecimal digits"};
  }
  return result;
}

template <std::size_t count>
std::array<double, count> numbers(const json& value) {
  if (!value.is_array() || value.size() != count) {
    throw Problem{"", "is not a list of " + std::to_string(count) + " numbers"};
  }
  std::array<double, count> result;
  std::size_t filled = 0;
  for_each_item(value, [&](const json& item) { result[filled++] = number(item); });
  return result;
}

glm::dquat unit_quaternion(const json& value) {
  const auto [w, x, y, z] = numbers<4>(value);
  const glm::dquat rotation(w, x, y, z);
  if (!is_unit(rotation)) {
    throw Problem{"", "is not a unit quaternion"};
  }
  return rotation;
}

glm::dvec3 vector(const json& value) {
  const auto [x, y, z] = numbers<3>(value);
  return {x, y, z};
}

Sculpture::Input input(const json& value) {
  Sculpture::Input result{within(value, "path", inner_path), within(value, "sha256", digest)};
  if (value.contains("credit")) {
    result.credit = within(value, "credit", credit_from_json);
  }
  return result;
}

Sculpture::Element element(const json& value) {
  return {input(value), within(value, "name", text), within(value, "size", positive)};
}

Instance instance(const json& value, std::size_t element_count) {
  Instance result;
  result.element = static_cast<std::uint32_t>(within(value, "element", [&](const json& index) {
    if (natural(index) >= element_count) {
      throw Problem{"", "is not the index of an element"};
    }
    return natural(index);
  }));
  result.scale = within(value, "scale", positive);
  result.rotation = within(value, "rotation", unit_quaternion);
  result.translation = within(value, "translation", vector);
  return result;
}

/// The file's format fits; do its parts fit each other?
void require_consistent(const Sculpture& sculpture, std::uint64_t seed) {
  if (sculpture.elements.size() != sculpture.options.elements.size()) {
    throw Problem{".elements", "are not as many as options.element"};
  }
  if (sculpture.props.size() != sculpture.options.render.props.size()) {
    throw Problem{".props", "are not as many as options.render.props"};
  }
  if (seed != sculpture.options.packing.seed) {
    throw Problem{".seed", "differs from options.packing.seed"};
  }
  const Scene::Target& target = sculpture.options.target;
  if (int{!target.mesh.empty()} + int{!target.sdf.empty()} + int{!target.text.string.empty()} !=
      1) {
    throw Problem{".options.target", "does not name exactly one of mesh, sdf and text"};
  }
  for (std::size_t k = 0; k < sculpture.options.elements.size(); ++k) {
    const Scene::Element& element = sculpture.options.elements[k];
    if (element.mesh.empty() == element.text.string.empty()) {
      throw Problem{".options.element[" + std::to_string(k) + "]",
                    "does not name exactly one of mesh and text"};
    }
  }
}

Sculpture sculpture(const json& root) {
  Sculpture result;
  result.version = within(root, "version", text);
  result.command = within(root, "command", text);
  result.options = within(root, "options", options_from_json);
  result.target = within(root, "target", input);
  within(root, "elements", [&](const json& list) {
    for_each_item(list, [&](const json& item) { result.elements.push_back(element(item)); });
  });
  if (root.contains("props")) {
    within(root, "props", [&](const json& list) {
      for_each_item(list, [&](const json& item) { result.props.push_back(input(item)); });
    });
  }
  if (root.contains("scene_sha256")) {
    result.scene_sha256 = within(root, "scene_sha256", digest);
  }
  if (root.contains("stopped")) {
    result.stopped = within(root, "stopped", text);
  }
  within(root, "instances", [&](const json& list) {
    result.instances.reserve(list.size());
    for_each_item(list, [&](const json& item) {
      result.instances.push_back(instance(item, result.elements.size()));
    });
  });
  require_consistent(result, within(root, "seed", natural));
  return result;
}

/// Of a file as write_sculpture() writes it the instances' lines, and JSON of the rest.
std::optional<Sculpture> sculpture_as_written(std::string_view text) {
  constexpr std::string_view begin = "  \"instances\": [\n";
  constexpr std::string_view end = "\n  ]\n}\n";
  const std::size_t found = text.find(begin);
  if (found == std::string_view::npos || !text.ends_with(end)) {
    return std::nullopt;
  }
  const std::size_t first = found + begin.size();
  if (first + end.size() > text.size()) {
    return std::nullopt;
  }
  const std::string_view lines = text.substr(first, text.size() - end.size() - first);
  const json rest = json::parse(std::string(text.substr(0, first)) + "]}", nullptr, false);
  if (rest.is_discarded()) {
    return std::nullopt;
  }
  try {
    Sculpture result = sculpture(rest);
    auto instances = read_instance_lines(lines, result.elements.size());
    if (!instances) {
      return std::nullopt;
    }
    result.instances = std::move(*instances);
    return result;
  } catch (const Problem&) {
    return std::nullopt;  // the reader of it all says where
  }
}

}  // namespace

void write_sculpture(const std::filesystem::path& path, const Sculpture& sculpture) {
  const Scene scene = with_copies(sculpture);
  FileWriter file(path);
  const std::string& digest = sculpture.scene_sha256;
  file.append("{\n  \"version\": " + json_text(sculpture.version) +
              ",\n  \"command\": " + json_text(sculpture.command) + ",\n  \"seed\": " +
              std::to_string(scene.packing.seed) + stopped_members(sculpture.stopped) +
              ",\n  \"options\": " + options_json(scene) + ",\n" + inputs_text(sculpture) +
              (digest.empty() ? "" : "  \"scene_sha256\": " + json_text(digest) + ",\n") +
              "  \"instances\": [");
  std::string line = "\n";
  for (const Instance& instance : sculpture.instances) {
    append_instance(line, instance);
    file.append(line);
    line = ",\n";
  }
  file.append("\n  ]\n}\n");
  file.commit();
}

Sculpture read_sculpture(const fs::path& path) {
  const std::string text = read_file(path);
  try {
    std::optional<Sculpture> written = sculpture_as_written(text);
    Sculpture result = written ? std::move(*written) : sculpture(json_reader::parsed(path, text));
    result.options.name = fs::absolute(path).lexically_normal().parent_path().filename().string();
    result.options.file = path;
    return result;
  } catch (const Problem& problem) {
    throw json_reader::error_in(path, problem);
  }
}

}  // namespace collage
