#pragma once

#include <string>

namespace collage {

/// All options for the terminal, one a line under its section: name, default, meaning and what it
/// takes.
std::string options_text();

/// The page docs/scene-reference.md: every key of a scene file, its default, what it takes and what
/// it means.
std::string scene_reference_markdown();

}  // namespace collage
