#include "cli/read_mesh.h"

#include <string>

namespace collage {

MeshFile read_mesh(const std::filesystem::path& path, Repair repair, Status& status) {
  MeshFile file = read_obj(path, status);
  if (repair == Repair::orient) {
    if (const std::string done = text_of(orient(file.mesh)); !done.empty()) {
      status.note(path.filename().string() + ": " + done);
    }
  }
  return file;
}

}  // namespace collage
