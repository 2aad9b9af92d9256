#pragma once

#include <filesystem>

#include "audit/silhouette.h"

namespace collage {

/// <folder>/sheets/outline.png.
std::filesystem::path outline_path(const std::filesystem::path& folder);

/// Writes two outlines laid over each other as a PNG: dark where both are, red where the sculpture
/// is missing, blue where it sticks out. Throws Error where it cannot be written.
void write_outline(const std::filesystem::path& path, const SilhouettePicture& outline);

}  // namespace collage
