#include "cli/finished_folder.h"

#include "base/error.h"
#include "base/file.h"
#include "cli/read_mesh.h"
#include "cli/version.h"
#include "scene/sculpture_file.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

Mesh read_input(const fs::path& folder, const Sculpture::Input& input, Repair repair) {
  const fs::path path = folder / input.path;
  if (sha256(read_file(path)) != input.sha256) {
    throw Error({path}, "is not the file that the sculpture was made from",
                "put the original back, or pack the scene again");
  }
  Status silent;  // what there was to say of the mesh was said when it was packed
  return read_mesh(path, repair, silent).mesh;
}

}  // namespace

Sculpture read_finished_sculpture(const fs::path& folder) {
  if (!fs::exists(folder / "sculpture.json")) {
    throw Error({folder}, "holds no sculpture.json",
                "name a folder that `collage pack` or `collage make` has written");
  }
  return read_sculpture(folder / "sculpture.json");
}

FinishedFolder read_finished_folder(const fs::path& folder, Status& status) {
  FinishedFolder finished;
  finished.sculpture = read_finished_sculpture(folder);
  const Scene& options = finished.sculpture.options;
  for (std::size_t e = 0; e < options.elements.size(); ++e) {
    if (status.stop_requested()) {
      throw Interrupted();
    }
    finished.elements.push_back(
        read_input(folder, finished.sculpture.elements[e], options.elements[e].repair));
  }
  for (const Sculpture::Input& prop : finished.sculpture.props) {
    finished.props.push_back(read_input(folder, prop, Repair::orient));
  }
  if (options.target.sdf.empty()) {
    finished.target = read_input(folder, finished.sculpture.target, options.target.repair);
  }
  return finished;
}

Composition composition_of(const FinishedFolder& finished) {
  const Sculpture& sculpture = finished.sculpture;
  Composition composition;
  composition.name = sculpture.options.name;
  composition.made_by = std::string("collage ") + version;
  for (std::size_t e = 0; e < finished.elements.size(); ++e) {
    const Scene::Element& options = sculpture.options.elements[e];
    composition.elements.push_back(
        {sculpture.elements[e].name, finished.elements[e], options.color, options.finish});
  }
  for (std::size_t k = 0; k < finished.props.size(); ++k) {
    composition.props.push_back({sculpture.props[k].path.stem().string(), finished.props[k]});
  }
  composition.instances = sculpture.instances;
  if (finished.target) {
    composition.target = &*finished.target;
    composition.target_box = bounding_box(*finished.target);
  }
  return composition;
}

}  // namespace collage
