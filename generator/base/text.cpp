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

std::optional<char32_t> take_character(std::string_view& text) {
  const auto take = [&] {
    const auto byte = static_cast<unsigned char>(text.front());
    text.remove_prefix(1);
    return byte;
  };
  const unsigned char first = take();
  if (first < 0x80) {
    return first;
  }
  const int tail = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : 1;
  char32_t character = first & (0x3FU >> tail);
  for (int i = 0; i < tail; ++i) {
    if (first < 0xC2 || text.empty() || (static_cast<unsigned char>(text.front()) & 0xC0) != 0x80) {
      return std::nullopt;
    }
    character = (character << 6) | (take() & 0x3FU);
  }
  constexpr std::array<char32_t, 3> least{0x80, 0x800, 0x10000};
  const bool surrogate = character >= 0xD800 && character < 0xE000;
  const bool valid = first < 0xF8 && character >= least[static_cast<std::size_t>(tail - 1)] &&
                     character <= 0x10FFFF && !surrogate;
  return valid ? std::optional(character) : std::nullopt;
}

}  // namespace collage
