#include "geometry/obj_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace collage {
namespace {

constexpr std::string_view blanks = " \t";

/// The first line of `rest`, which is cut off it; ends are "\n", "\r\n" and "\r".
std::string_view take_line(std::string_view& rest) {
  const std::size_t end = std::min(rest.find_first_of("\r\n"), rest.size());
  const std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end);
  rest.remove_prefix(rest.starts_with("\r\n") ? 2 : rest.empty() ? 0 : 1);
  return line;
}

/// The first word of `rest`, which is cut off it; empty where none is left.
std::string_view take_word(std::string_view& rest) {
  rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
  const std::size_t end = std::min(rest.find_first_of(blanks), rest.size());
  const std::string_view word = rest.substr(0, end);
  rest.remove_prefix(end);
  return word;
}

double read_number(std::string_view word) {
  if (word.starts_with('+')) {
    word.remove_prefix(1);
  }
  double value = 0.0;
  const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool whole = result.ec == std::errc() && result.ptr == word.data() + word.size();
  return whole && std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN();
}

dvec3 read_position(std::string_view words) {
  dvec3 position;
  for (int axis = 0; axis < 3; ++axis) {
    position[axis] = read_number(take_word(words));
  }
  const bool readable = !std::isnan(position.x + position.y + position.z);
  return readable ? position : dvec3(std::numeric_limits<double>::quiet_NaN());
}

void normalise(std::string_view text, std::string& out) {
  out.reserve(text.size() + 1);
  std::size_t owed_lines = 0;
  while (!text.empty()) {
    std::string_view line = take_line(text);
    if (line.ends_with('\\')) {
      line.remove_suffix(1);
      out.append(line).push_back(' ');
      ++owed_lines;
      continue;
    }
    out.append(line).push_back('\n');
    out.append(owed_lines, '\n');
    owed_lines = 0;
  }
  out.append(owed_lines + 1, '\n');
}

/// Overwrites by blanks, in lines that hold only numbers, what stands behind '#', and slashes with
/// nothing behind them, after which tinyobjloader would take the next corner's number.
void blank_out(std::string& text) {
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = text.find('\n', start);
    const std::size_t first = text.find_first_not_of(blanks, start);
    if (text[first] == 'v' || text[first] == 'f') {
      const std::string_view line(text.data() + first, end - first);
      const std::size_t comment = first + std::min(line.find('#'), line.size());
      bool at_gap = true;
      for (std::size_t i = end; i-- > first;) {
        if (i >= comment || (at_gap && text[i] == '/')) {
          text[i] = ' ';
        }
        at_gap = text[i] == ' ' || text[i] == '\t';
      }
    }
    start = end + 1;
  }
}

bool holds_overflowing_index(std::string_view words) {
  constexpr std::string_view digits = "0123456789";
  while (true) {
    words.remove_prefix(std::min(words.find_first_of(digits), words.size()));
    if (words.empty()) {
      return false;
    }
    const std::size_t end = std::min(words.find_first_not_of(digits), words.size());
    int index = 0;
    if (std::from_chars(words.data(), words.data() + end, index).ec != std::errc()) {
      return true;
    }
    words.remove_prefix(end);
  }
}

void scan_line(std::string_view line, int number, ObjText& result) {
  const std::string_view keyword = take_word(line);
  if (line.empty()) {
    return;  // a keyword alone; tinyobjloader wants a blank behind it as well
  }
  if (keyword == "v") {
    result.positions.push_back(read_position(line));
    result.position_lines.push_back(number);
  } else if (keyword == "f" && line.find_first_not_of(blanks) != std::string_view::npos) {
    result.face_lines.push_back(number);
    if (!result.overflowing_face_line && holds_overflowing_index(line)) {
      result.overflowing_face_line = number;
    }
  } else if (keyword == "mtllib") {
    result.libraries.emplace_back(trimmed(line));
  }
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

ObjText scan_obj(std::string_view text) {
  ObjText result;
  normalise(text, result.text);
  blank_out(result.text);
  std::string_view rest = result.text;
  for (int number = 1; !rest.empty(); ++number) {
    scan_line(take_line(rest), number, result);
  }
  return result;
}

}  // namespace collage
