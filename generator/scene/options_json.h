#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "scene/scene.h"

namespace collage {

/// All options by section and key as a JSON object, for sculpture.json: {"target": {"mesh": …}, …,
/// "element": [{…}, …]}. Paths are written as they are.
std::string options_json(const Scene& scene);

/// Reads what options_json() wrote. Keys that are missing have their defaults; paths are kept as
/// they are, whether or not there are such files. Throws json_reader::Problem.
Scene options_from_json(const nlohmann::json& value);

}  // namespace collage
