#pragma once

#include <filesystem>
#include <string>

#include "fitting/shaped_element.h"

namespace collage {

/// $XDG_CACHE_HOME/collage, else ~/.cache/collage; empty where neither is known.
std::filesystem::path cache_folder();

/// measure_shape(), which takes seconds, remembered in a folder under the hash of all that it
/// depends on; what is read is what was measured, to the bit. A file appears whole or not at all,
/// so that processes may share the folder, and it may be deleted at any time. One that cannot be
/// read, or is not what was written, is measured anew and replaced; where the folder cannot be
/// written nothing is remembered. An empty folder: always measured.
ShapeData cached_shape(const Mesh& mesh, const Element& element,
                       const std::filesystem::path& folder);

}  // namespace collage
