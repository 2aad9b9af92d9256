#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "render/shot.h"

namespace collage {

/// Pixels as a file stores them: sRGB-encoded from a PNG (8 bits n as n/255), linear from an EXR.
/// Rows run from the top, channels are interleaved.
struct Picture {
  int width = 0;
  int height = 0;
  int channels = 3;
  PictureFormat format = PictureFormat::png;
  std::vector<float> values;
  /// What write_picture() was given; "" for pictures of others.
  std::string key;

  [[nodiscard]] std::size_t pixels() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
};

/// Reads a PNG or EXR to its last row. Throws Error where it is missing, cut short, damaged or no
/// picture, has more than 2^28 pixels, or takes more memory than may be taken.
Picture read_picture(const std::filesystem::path& path);

/// Writes a picture under its final name, whole or not at all, in `picture.format`, with
/// its key as metadata and without date: equal pictures give equal bytes. Throws Error where the
/// folder cannot be written to.
void write_picture(const std::filesystem::path& path, const Picture& picture);

}  // namespace collage
