#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "base/status.h"

namespace collage {

/// A picture in the output folder under a name of ours, so that no name from a mesh file reaches
/// POV-Ray.
struct TextureCopy {
  /// "texture-0.png"
  std::string name;
  /// POV-Ray's keyword for the format: png, jpeg, gif, tga, bmp, ppm, pgm or tiff.
  std::string format;
};

/// Copies pictures into a folder as texture-0.png, texture-1.jpg, … in the order of the calls.
class TextureCopies {
 public:
  TextureCopies(std::filesystem::path folder, Status& status)
      : folder_(std::move(folder)), status_(status) {}

  /// The copy of a picture; the same picture, whatever its path, is copied once. Nothing, and a
  /// note, where it cannot be read, is not of a format that POV-Ray reads or claims over 2^28
  /// pixels. Throws Error where the copy cannot be written.
  std::optional<TextureCopy> add(const std::filesystem::path& picture);

 private:
  std::optional<std::string> content_of(const std::filesystem::path& picture);

  std::filesystem::path folder_;
  Status& status_;
  std::map<std::string, TextureCopy> by_hash_;
};

/// Width times height, as a picture of this format and content says in its head; 0 where it does
/// not say, or in a format that we do not look into (TIFF).
std::uint64_t claimed_pixels(std::string_view content, std::string_view format);

/// POV-Ray's keyword for a picture of this content, by its first bytes (TGA, which has no mark
/// there, by the extension); "" for other formats.
std::string_view picture_format(std::string_view content, const std::filesystem::path& name);

}  // namespace collage
