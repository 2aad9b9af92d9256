#include "scene/texture_copies.h"

#include <array>

#include "base/error.h"
#include "base/file.h"

namespace collage {
namespace {

using namespace std::string_view_literals;

constexpr std::uintmax_t largest_picture_bytes = std::uintmax_t{512} << 20;

struct Mark {
  std::string_view first_bytes;
  std::string_view format;
};

constexpr std::array marks{Mark{"\x89PNG\r\n\x1a\n"sv, "png"sv},
                           Mark{"\xff\xd8\xff"sv, "jpeg"sv},
                           Mark{"GIF8"sv, "gif"sv},
                           Mark{"BM"sv, "bmp"sv},
                           Mark{"P6"sv, "ppm"sv},
                           Mark{"P3"sv, "ppm"sv},
                           Mark{"P5"sv, "pgm"sv},
                           Mark{"P2"sv, "pgm"sv},
                           Mark{"II*\0"sv, "tiff"sv},
                           Mark{"MM\0*"sv, "tiff"sv}};

std::string_view extension_of(std::string_view format) {
  return format == "jpeg" ? "jpg"sv : format == "tiff" ? "tif"sv : format;
}

}  // namespace

std::string_view picture_format(std::string_view content, const std::filesystem::path& name) {
  for (const Mark& mark : marks) {
    if (content.starts_with(mark.first_bytes)) {
      return mark.format;
    }
  }
  const std::string extension = name.extension().string();
  return extension == ".tga" || extension == ".TGA" ? "tga"sv : ""sv;
}

std::optional<std::string> TextureCopies::content_of(const std::filesystem::path& picture) {
  try {
    return read_file(picture, largest_picture_bytes);
  } catch (const Error& error) {
    status_.note(std::string(error.what()) + "; the material's colour is used");
    return std::nullopt;
  }
}

std::optional<TextureCopy> TextureCopies::add(const std::filesystem::path& picture) {
  const std::optional<std::string> content = content_of(picture);
  if (!content) {
    return std::nullopt;
  }
  const std::string_view format = picture_format(*content, picture);
  if (format.empty()) {
    status_.note(picture.string() + " is not a picture that POV-Ray reads (PNG, JPEG, GIF, TGA, " +
                 "BMP, PPM or TIFF); the material's colour is used");
    return std::nullopt;
  }
  TextureCopy copy{
      "texture-" + std::to_string(by_hash_.size()) + "." + std::string(extension_of(format)),
      std::string(format)};
  const auto [known, is_new] = by_hash_.emplace(sha256(*content), std::move(copy));
  if (is_new) {
    write_file(folder_ / known->second.name, *content);
  }
  return known->second;
}

}  // namespace collage
