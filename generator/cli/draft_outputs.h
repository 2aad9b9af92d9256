#pragma once

#include <filesystem>
#include <vector>

#include "base/status.h"
#include "cli/finished_folder.h"
#include "render/process.h"

namespace collage {

/// All pictures that the scene asks for, as previews, in the folder draft/ of a finished folder:
/// the names are those of render_outputs(), and no picture that POV-Ray made is touched. Returns
/// where they are. Throws Interrupted.
std::vector<std::filesystem::path> draft_outputs(const std::filesystem::path& folder,
                                                 const FinishedFolder& finished, const Scene& scene,
                                                 CommandRunner& runner, Status& status);

}  // namespace collage
