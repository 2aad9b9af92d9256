#pragma once

#include <filesystem>

#include "scene/mesh_library.h"
#include "scene/scene.h"

namespace collage {

/// Reads a scene file, TOML with the keys of options_table(); `path` is the file or a folder with a
/// scene.toml in it. The scene is called as the folder is, or as the file where that is not named
/// scene.toml. Relative paths in it start from its folder, meshes of libraries are looked for in
/// `libraries`, and the files that it names exist.
///
/// Throws Error with file and line for everything that is not right: not TOML, unknown keys, values
/// of the wrong type or out of range, missing files, no target or two of them, no element, a file
/// of more than 1 MiB or with more dots in it than any scene has.
Scene read_scene(const std::filesystem::path& path, const MeshLibraries& libraries = {});

}  // namespace collage
