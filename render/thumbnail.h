#pragma once

#include <filesystem>

#include "render/picture_file.h"

namespace collage {

/// The picture (PNG or EXR) in three sRGB-encoded channels, made smaller in linear light where it
/// is larger than a square of `side` pixels (≥ 1), and at its own size where it is not. A grey
/// picture becomes three equal channels; alpha is left out. Throws Error where it cannot be read.
Picture thumbnail(const std::filesystem::path& path, int side);

}  // namespace collage
