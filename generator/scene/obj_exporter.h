#pragma once

#include <filesystem>

#include "base/status.h"
#include "scene/composition.h"

namespace collage {

/// Writes all instances as one Wavefront OBJ (the export of Muhm 2011), a group "g teacup.12" each,
/// numbered in the order of placement, and beside it an MTL of the same name and the pictures that
/// the materials use. Each file appears whole or not at all, the OBJ last. Positions and normals
/// are transformed in double and written as the shortest text that reads back the same.
///
/// Throws Error where a file cannot be written, Interrupted where the user stops it. Cost: a
/// microsecond and about 100 bytes for each triangle of each instance; memory does not grow with
/// the number of instances.
void export_obj(const std::filesystem::path& path, const Composition& composition, Status& status);

}  // namespace collage
