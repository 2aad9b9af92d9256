#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/status.h"
#include "scene/report_file.h"
#include "scene/scene.h"

namespace collage {

/// When packing may end before the space is full.
struct PackingEnd {
  enum class OnInterrupt { stop, finish };
  /// After so many seconds from now, preparation included; one instance at least is placed.
  std::optional<double> seconds{};
  /// What Ctrl-C does while elements are placed: stop without a result, or finish with those.
  OnInterrupt on_interrupt = OnInterrupt::stop;
};

/// Packs a scene and writes everything that rendering it takes into `folder`: sculpture.json,
/// scene.pov, report.json, the templates, copies of the inputs and textures. `command` is what the
/// sculpture says it was made by. All files appear at once, or none; the folder must be locked by a
/// FolderLock, or used by nobody else.
/// Throws Error where an input is bad, nothing fits or the folder cannot be written.
Report pack_scene(const Scene& scene, const std::string& command,
                  const std::filesystem::path& folder, Status& status, const PackingEnd& end = {});

}  // namespace collage
