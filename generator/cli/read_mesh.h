#pragma once

#include <filesystem>

#include "base/status.h"
#include "geometry/mesh_check.h"
#include "geometry/mesh_file.h"

namespace collage {

/// Reads an OBJ as read_obj() does, puts it right where that is wanted, and says what was done.
MeshFile read_mesh(const std::filesystem::path& path, Repair repair, Status& status);

}  // namespace collage
