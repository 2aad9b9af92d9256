#pragma once

#include <string>
#include <vector>

#include "scene/option.h"

namespace collage {

/// All keys of a scene file, in the order in which they are listed and written. Scene files,
/// `--set`, sculpture.json, the messages and the reference page derive from it; a new option is a
/// field of a struct and a row here.
const std::vector<Option>& options_table();

/// "target", "element", "packing", … in the table's order.
const std::vector<std::string>& option_sections();

/// The row of "packing.threshold", or nullptr.
const Option* find_option(const std::string& key);

}  // namespace collage
