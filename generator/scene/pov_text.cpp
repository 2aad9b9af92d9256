#include "scene/pov_text.h"

#include <algorithm>
#include <string_view>

#include "base/text.h"

namespace collage {
namespace {

constexpr std::size_t longest_name = 60;

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view(" .-_").find(c) != std::string_view::npos;
}

bool is_printable(char c) { return c >= ' ' && c <= '~'; }

}  // namespace

std::string plain_name(const std::string& name) {
  std::string plain = name.substr(0, longest_name);
  std::replace_if(
      plain.begin(), plain.end(), [](char c) { return !is_plain(c); }, '_');
  return plain;
}

std::string pov_string(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted += '\\';
    }
    quoted += is_printable(c) ? c : '_';
  }
  return quoted + '"';
}

void append_vector(std::string& text, std::initializer_list<double> numbers) {
  const char* separator = "<";
  for (const double number : numbers) {
    text += separator;
    append_number(text, number);
    separator = ", ";
  }
  text += '>';
}

void append_vector(std::string& text, const glm::dvec3& v) { append_vector(text, {v.x, v.y, v.z}); }

std::string pov_vector(const glm::dvec3& v) {
  std::string text;
  append_vector(text, v);
  return text;
}

}  // namespace collage
