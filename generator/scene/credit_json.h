#pragma once

#include <string>

#include "scene/credit.h"
#include "scene/json_reader.h"

namespace collage {

/// A credit as one line of JSON. Throws Error where a text is not UTF-8.
std::string credit_json(const Credit& credit);

/// Its inverse. Throws json_reader::Problem.
Credit credit_from_json(const json_reader::json& value);

}  // namespace collage
