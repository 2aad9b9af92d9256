#pragma once

#include <string>
#include <string_view>

namespace collage {

/// Text as HTML, safe between tags and in quoted attributes: what has a meaning there is escaped,
/// and control characters but for tab and line feed become U+FFFD.
std::string html_text(std::string_view text);

/// A relative path as a URL, whatever has a meaning in one written as %xx: it cannot name a scheme.
std::string url_path(std::string_view path);

}  // namespace collage
