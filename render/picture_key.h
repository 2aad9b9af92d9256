#pragma once

#include <filesystem>
#include <string>

#include "render/povray.h"
#include "render/shot.h"

namespace collage {

/// SHA-256 over what POV-Ray reads in the folder of a scene: scene.pov, the templates (.inc) and
/// every file beside them that they name in quotes, such as "texture-0.png". Throws Error where
/// there is no scene.pov. Cost: reads these files once.
std::string scene_digest(const std::filesystem::path& folder);

/// Names the picture that POV-Ray makes of a shot; equal keys, equal picture (with Quality::fine,
/// but for noise). The number of threads has no part in it.
std::string picture_key(const std::string& scene_digest, const Shot& shot, const Povray& povray);

}  // namespace collage
