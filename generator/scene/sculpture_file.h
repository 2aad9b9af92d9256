#pragma once

#include <filesystem>

#include "scene/sculpture.h"

namespace collage {

/// Writes sculpture.json, whole or not at all:
///
///     {"version", "command", "seed", "options": {section: {key: value}},
///      "target": {"path", "sha256"}, "elements": [{"name", "path", "sha256", "size"}],
///      "instances": [{"element", "scale", "rotation": [w, x, y, z], "translation": [x, y, z]}]}
///
/// with one instance a line and numbers as the shortest text that reads back the same. In "options"
/// the paths are those of the copies. Throws Error where the file cannot be written or a name in it
/// is not UTF-8. Cost: about a microsecond an instance.
void write_sculpture(const std::filesystem::path& path, const Sculpture& sculpture);

/// Reads what write_sculpture() wrote. The paths stay relative to the folder of the file. Throws
/// Error that names the JSON path of whatever is missing, of the wrong type, not finite, out of
/// range, a path out of the folder, or not a unit quaternion (within 1e-6). Options that an older
/// version did not know get their defaults. Memory while reading: about 1 kB an instance.
Sculpture read_sculpture(const std::filesystem::path& path);

}  // namespace collage
