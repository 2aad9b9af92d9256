#pragma once

#include <filesystem>

#include "audit/audit.h"
#include "base/status.h"
#include "cli/finished_folder.h"

namespace collage {

/// Writes a folder like `source` that holds only the instances that break a promise, so that
/// `collage still` shows them; `finished` is what `source` holds. Writes nothing where no instance
/// breaks one. Throws Error where the folder cannot be written.
void write_offenders(const std::filesystem::path& source, const FinishedFolder& finished,
                     const Audit& audit, const std::filesystem::path& folder, Status& status);

}  // namespace collage
