#include "cli/read_mesh.h"

#include <string>

#include "geometry/mesh_repair.h"

namespace collage {

MeshFile read_mesh(const std::filesystem::path& path, Repair repair, Status& status) {
  MeshFile file = read_obj(path, status);
  if (repair == Repair::full) {
    for (const std::string& done : collage::repair(file.mesh)) {
      status.note(path.filename().string() + ": " + done);
    }
  }
  return file;
}

}  // namespace collage
