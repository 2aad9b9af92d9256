#include "scene/copy_inputs.h"

#include <cassert>

#include "base/file.h"
#include "geometry/mesh_file.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

bool is_inside(const fs::path& relative) {
  return !relative.empty() && relative.is_relative() && *relative.begin() != "..";
}

}  // namespace

Sculpture::Input copy_inputs(const std::vector<fs::path>& files, const fs::path& folder,
                             const std::string& role, Status& status) {
  assert(!files.empty());
  const fs::path destination = fs::path("meshes") / role;
  const fs::path source = fs::absolute(files.front()).lexically_normal().parent_path();
  Sculpture::Input input;
  for (const fs::path& file : files) {
    const fs::path relative = fs::absolute(file).lexically_normal().lexically_relative(source);
    if (!is_inside(relative)) {
      status.note(file.string() + " is not in the folder of " + files.front().string() +
                  " and is not copied");
      continue;
    }
    const std::string content = read_file(file);
    write_file(folder / destination / relative, content);
    if (input.path.empty()) {
      input = {destination / relative, sha256(content), read_credit(file)};
    }
  }
  return input;
}

Sculpture::Input write_input(const Mesh& mesh, const std::string& name, const fs::path& folder,
                             const std::string& role) {
  const fs::path path = fs::path("meshes") / role / (name + ".obj");
  write_obj(folder / path, mesh, "");
  return {path, sha256(read_file(folder / path))};
}

}  // namespace collage
