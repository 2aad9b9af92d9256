#pragma once

#include <string>

#include "scene/mesh_library.h"
#include "scene/scene.h"

namespace collage {

/// Sets one option as `--set` has it: "packing.threshold=0.01", "element.0.color=#c8102e",
/// "render.stills=front,30/15", "render.size=640,480". Relative paths start from the current
/// folder, meshes of libraries are looked for in `libraries`. Naming a mesh takes the place of a
/// grid of distances, and the other way round. Throws Error where the key is unknown or the value
/// is not accepted.
void set_option(Scene& scene, const std::string& assignment, const MeshLibraries& libraries = {});

}  // namespace collage
