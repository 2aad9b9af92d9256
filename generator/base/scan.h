#pragma once

#include <charconv>
#include <string_view>
#include <system_error>

namespace collage {

/// Takes `prefix` off the front of `text`, or says that it is not there.
inline bool skip(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) {
    return false;
  }
  text.remove_prefix(prefix.size());
  return true;
}

/// Takes a number off the front of `text`; false where there is none, or none of its type.
template <class Number>
bool read_number(std::string_view& text, Number& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return error == std::errc{};
}

}  // namespace collage
