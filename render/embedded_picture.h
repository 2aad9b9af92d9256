#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace collage {

/// A picture as part of a text: `uri` is a data: URI (RFC 2397).
struct EmbeddedPicture {
  std::string uri;
  int width = 0;
  int height = 0;
};

/// Reads a picture (PNG or EXR), makes it smaller in linear light where it is larger than a square
/// of `side` pixels, and encodes it as PNG or JPEG, whichever is shorter: flat drawings stay exact,
/// renderings become about ten times smaller. Alpha is left out. Equal input gives equal text.
/// Throws Error where the picture cannot be read.
EmbeddedPicture embedded_picture(const std::filesystem::path& path, int side);

/// RFC 4648, section 4.
std::string base64(std::string_view bytes);

}  // namespace collage
