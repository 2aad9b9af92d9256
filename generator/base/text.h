#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace collage {

/// Appends the shortest text that reads back as the same double, "1.5", "-0.001", "1e+30".
/// `value` must be finite.
void append_number(std::string& text, double value);
std::string number_text(double value);

/// "334,972": for people, not for files.
std::string grouped(std::uint64_t value);

/// Takes one character of UTF-8 off the front of `text`, which is not empty. Nothing where it is
/// none (cut short, longer than need be, a surrogate, beyond U+10FFFF): the bytes that cannot be
/// read are taken off all the same.
std::optional<char32_t> take_character(std::string_view& text);

}  // namespace collage
