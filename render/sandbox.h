#pragma once

#include <filesystem>

#include "render/process.h"

namespace collage {

/// The command run inside bubblewrap (its program is `bwrap`): it sees the system's programs,
/// POV-Ray's own settings and the program's folder, all read-only, and its working folder, the only
/// one that it can write to; no network, no other process, and nothing else of the user's.
Command sandboxed(const std::filesystem::path& bwrap, const Command& command);

}  // namespace collage
