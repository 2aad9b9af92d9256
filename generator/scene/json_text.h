#pragma once

#include <optional>
#include <string>

#include "scene/option.h"

namespace collage {

/// `text` in JSON's quotes, in ASCII. Throws Error where it is not UTF-8.
std::string json_text(const std::string& text);

/// `value` as JSON; numbers, which must be finite, as the shortest text that reads back the same.
std::string json_text(const OptionValue& value);

/// Members that mark a packing that was ended early, by `stopped`; nothing for one that was not.
std::string stopped_members(const std::optional<std::string>& stopped);

}  // namespace collage
