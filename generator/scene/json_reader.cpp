#include "scene/json_reader.h"

#include <cmath>

#include "base/file.h"

namespace collage::json_reader {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_message = 200;  // a message may quote the file

}  // namespace

double number(const json& value) {
  if (!value.is_number() || !std::isfinite(value.get<double>())) {
    throw Problem{"", "is not a finite number"};
  }
  return value.get<double>();
}

double positive(const json& value) {
  const double result = number(value);
  if (!(result > 0.0)) {
    throw Problem{"", "is not greater than 0"};
  }
  return result;
}

std::uint64_t natural(const json& value) {
  if (!value.is_number_unsigned()) {
    throw Problem{"", "is not a whole number from 0"};
  }
  return value.get<std::uint64_t>();
}

std::string text(const json& value) {
  if (!value.is_string()) {
    throw Problem{"", "is not text"};
  }
  return value.get<std::string>();
}

json parsed(const fs::path& path, std::string_view text, const char* remedy) {
  try {
    return json::parse(text);
  } catch (const json::exception& error) {
    throw Error({path}, "is not JSON: " + std::string(error.what()).substr(0, longest_message),
                remedy);
  }
}

json parsed_file(const fs::path& path, const char* remedy) {
  return parsed(path, read_file(path), remedy);
}

Error error_in(const fs::path& path, const Problem& problem, const char* remedy) {
  const std::string where = problem.where.empty() ? "" : problem.where.substr(1) + " ";
  return {{path}, where + problem.what, remedy};
}

}  // namespace collage::json_reader
