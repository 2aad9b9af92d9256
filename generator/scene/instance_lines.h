#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/instance.h"

namespace collage {

/// Whether a rotation read from a file is one; its length may be off by 10⁻⁶.
bool is_unit(const glm::dquat& rotation);

/// Appends an instance as an item of sculpture.json, which has one a line.
void append_instance(std::string& text, const Instance& instance);

/// The instances of lines that stand exactly as append_instance() has them, with a comma at the end
/// of all but the last. Nothing where one does not, or is no instance of one of so many elements:
/// what is wrong is then for a reader of JSON to say. On all threads, about 200 ns a line on each.
std::optional<std::vector<Instance>> read_instance_lines(std::string_view lines,
                                                         std::size_t element_count);

}  // namespace collage
