#pragma once

#include <filesystem>

#include "cli/audit_folder.h"
#include "cli/finished_folder.h"
#include "scene/report_file.h"

namespace collage {

/// Writes report.html into a finished folder: its pictures as far as they are there, what was
/// proved and measured of it, and how to make it again.
void write_sculpture_page(const std::filesystem::path& folder, const FinishedFolder& finished,
                          const Report& report, const FolderAudit& audit);

}  // namespace collage
