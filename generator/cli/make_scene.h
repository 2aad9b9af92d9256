#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/audit_folder.h"
#include "cli/pack_scene.h"
#include "render/render_pictures.h"
#include "scene/report_file.h"
#include "scene/scene.h"

namespace collage {

/// What `make` did of a scene.
struct MadeScene {
  Report report;
  FolderAudit audit;
  /// None where the audit failed: what is wrong is not worth a picture.
  std::vector<std::filesystem::path> pictures;
};

/// Packs a scene into `folder`, audits what was written, and renders all that the scene asks for,
/// with a page about it, report.html. `command` is what the sculpture says it was made by.
MadeScene make_scene(const Scene& scene, const std::string& command,
                     const std::filesystem::path& folder, const RenderTools& tools,
                     const PackingEnd& end = {});

/// Audits a finished folder and writes audit.json there.
FolderAudit audit_and_note(const std::filesystem::path& folder, const FinishedFolder& finished,
                           Status& status, Measuring measuring = Measuring::all);

}  // namespace collage
