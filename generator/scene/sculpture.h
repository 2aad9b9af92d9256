#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/instance.h"
#include "scene/credit.h"
#include "scene/scene.h"

namespace collage {

/// What Sculpture::stopped says where the user ended the packing.
inline constexpr std::string_view ended_by_user = "Ctrl-C";

/// A finished packing with everything needed to make it again or to judge it. All paths in it are
/// relative to the folder of sculpture.json, which holds copies of the inputs, so that the folder
/// can be moved and holds the same bytes wherever it is.
struct Sculpture {
  struct Input {
    /// "meshes/element-0/teacup.obj"
    std::filesystem::path path;
    /// Of the file's content, 64 hexadecimal digits.
    std::string sha256;
    /// Whose work it is, where that is known.
    std::optional<Credit> credit{};
  };
  struct Element : Input {
    std::string name;
    /// Radius of the mesh's smallest enclosing sphere, in the mesh's units.
    double size = 0.0;
  };

  /// Of the program that made it, "0.1.0".
  std::string version;
  /// The command line that made it, for people.
  std::string command;
  /// Everything that was asked for; its seed is the sculpture's seed.
  Scene options;
  Input target;
  /// As many as options.elements, in the same order.
  std::vector<Element> elements;
  /// As many as options.render.props, in the same order.
  std::vector<Input> props{};
  /// Of the scene.pov that was written with it; empty where that is not known.
  std::string scene_sha256{};
  /// What ended the packing before the space was full, "time limit" or `ended_by_user`; none where
  /// nothing did. The file then says "complete": false as well.
  std::optional<std::string> stopped{};
  /// In the order of placement.
  std::vector<Instance> instances{};
};

}  // namespace collage
