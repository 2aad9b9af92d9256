#include "render/html_text.h"

#include <cctype>

#include <fmt/format.h>

namespace collage {
namespace {

bool is_control(char c) {
  const auto code = static_cast<unsigned char>(c);
  return (code < 0x20 && c != '\t' && c != '\n') || code == 0x7F;
}

}  // namespace

std::string html_text(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      default:
        safe += is_control(c) ? "\xEF\xBF\xBD" : std::string(1, c);
    }
  }
  return safe;
}

std::string url_path(std::string_view path) {
  std::string url;
  for (const char c : path) {
    const auto code = static_cast<unsigned char>(c);
    const bool is_plain =
        std::isalnum(code) != 0 || std::string_view("/._-~").find(c) != std::string_view::npos;
    url += is_plain ? std::string(1, c) : fmt::format("%{:02X}", code);
  }
  return url;
}

}  // namespace collage
