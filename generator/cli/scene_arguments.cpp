#include "cli/scene_arguments.h"

#include <fmt/format.h>

#include "base/error.h"
#include "cli/data_folder.h"
#include "scene/scene_file.h"
#include "scene/set_option.h"

namespace collage {

namespace fs = std::filesystem;

fs::path find_scene(const std::string& name) {
  if (fs::exists(name)) {
    if (fs::is_regular_file(name) && fs::path(name).extension() != ".toml") {
      throw Error({name}, "is no scene", "name a scene.toml or its folder");
    }
    return name;
  }
  const fs::path data = data_folder(data_places());
  for (const fs::path& path : {data / name, data / "scenes" / name}) {
    if (fs::exists(path)) {
      return path;
    }
  }
  throw Error({name}, "no such scene",
              "name a scene.toml or its folder; `collage scenes` lists those that come along");
}

Scene read_scene_with(const SceneArguments& arguments) {
  const MeshLibraries libraries = mesh_libraries();
  Scene scene = read_scene(find_scene(arguments.scene), libraries);
  for (const std::string& setting : arguments.settings) {
    set_option(scene, setting, libraries);
  }
  if (!arguments.seed.empty()) {
    set_option(scene, "packing.seed=" + arguments.seed);
  }
  return scene;
}

std::string command_text(const SceneArguments& arguments, const Scene& scene) {
  std::string text = "collage pack " + scene.name;
  for (const std::string& setting : arguments.settings) {
    text += " --set " + setting;
  }
  return arguments.seed.empty() ? text : text + fmt::format(" --seed {}", scene.packing.seed);
}

fs::path output_folder(const SceneArguments& arguments, const Scene& scene) {
  return arguments.folder.empty() ? fs::path("out") / scene.name : arguments.folder;
}

}  // namespace collage
