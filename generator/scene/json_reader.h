#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "base/error.h"

namespace collage {

/// Reads JSON that others may have written: every function throws Problem where the value is not
/// what it should be. For the .cpp files of this module.
namespace json_reader {

using nlohmann::json;

/// Something wrong below the place that is being read; within() adds where that is on the way out,
/// so that the good case builds no paths.
struct Problem {
  std::string where;
  std::string what;
};

/// What `read` makes of the member `name`.
template <class Read>
auto within(const json& parent, const char* name, Read read) {
  const auto found = parent.find(name);
  if (found == parent.end()) {
    throw Problem{std::string(".") + name, "is missing"};
  }
  try {
    return read(*found);
  } catch (const Problem& problem) {
    throw Problem{"." + (name + problem.where), problem.what};
  }
}

/// Calls `read` with each item of a list.
template <class Read>
void for_each_item(const json& array, Read read) {
  if (!array.is_array()) {
    throw Problem{"", "is not a list"};
  }
  std::size_t index = 0;
  try {
    for (const json& item : array) {
      read(item);
      ++index;
    }
  } catch (const Problem& problem) {
    throw Problem{"[" + std::to_string(index) + "]" + problem.where, problem.what};
  }
}

/// A finite number.
double number(const json& value);
/// A finite number greater than 0.
double positive(const json& value);
/// A whole number from 0 to 2^64 - 1.
std::uint64_t natural(const json& value);
std::string text(const json& value);

/// How to mend a file of a finished folder.
constexpr const char* make_again = "make the folder again with collage make";

/// The JSON of a file's text. Throws Error where it is none.
json parsed(const std::filesystem::path& path, std::string_view text,
            const char* remedy = make_again);
/// The file's JSON. Throws Error where it cannot be read or is not JSON.
json parsed_file(const std::filesystem::path& path, const char* remedy = make_again);

/// The Error that the user sees: "file: instances[3].scale is missing; remedy".
Error error_in(const std::filesystem::path& path, const Problem& problem,
               const char* remedy = make_again);

}  // namespace json_reader
}  // namespace collage
