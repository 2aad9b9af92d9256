#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/status.h"
#include "geometry/mesh.h"
#include "scene/sculpture.h"

namespace collage {

/// Copies an input into the folder of a sculpture, as meshes/<role>/<its name>, and the other files
/// that it uses beside it under the same relative names. `files` starts with the input itself;
/// files that lie outside its folder are left out, with a note. The credit is the one beside the
/// input, see read_credit(). Throws Error where a file cannot be read or written.
Sculpture::Input copy_inputs(const std::vector<std::filesystem::path>& files,
                             const std::filesystem::path& folder, const std::string& role,
                             Status& status);

/// Writes an input that was made, not read, into the folder, as meshes/<role>/<name>.obj. Throws
/// Error where it cannot be written.
Sculpture::Input write_input(const Mesh& mesh, const std::string& name,
                             const std::filesystem::path& folder, const std::string& role);

}  // namespace collage
