#include "base/text.h"

#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

namespace collage {

void append_number(std::string& text, double value) {
  assert(std::isfinite(value));
  std::array<char, 32> digits;
  const auto result = std::to_chars(digits.begin(), digits.end(), value);
  text.append(digits.data(), result.ptr);
}

std::string number_text(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

std::string grouped(std::uint64_t value) {
  std::string text = std::to_string(value);
  for (int at = static_cast<int>(text.size()) - 3; at > 0; at -= 3) {
    text.insert(static_cast<std::size_t>(at), ",");
  }
  return text;
}

}  // namespace collage
