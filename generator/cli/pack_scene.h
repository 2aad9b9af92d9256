#pragma once

#include <filesystem>
#include <string>

#include "base/status.h"
#include "scene/report_file.h"
#include "scene/scene.h"

namespace collage {

/// Packs a scene and writes everything that rendering it takes into `folder`: sculpture.json,
/// scene.pov, report.json, the templates, copies of the inputs and textures. `command` is what the
/// sculpture says it was made by. All files appear at once, or none; the folder must be locked by a
/// FolderLock, or used by nobody else.
/// Throws Error where an input is bad, nothing fits or the folder cannot be written.
Report pack_scene(const Scene& scene, const std::string& command,
                  const std::filesystem::path& folder, Status& status);

}  // namespace collage
