#include "render/embedded_picture.h"

#include <cstdint>

#include "render/imaging.h"
#include "render/picture_file.h"
#include "render/thumbnail.h"

namespace collage {

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::string_view group = bytes.substr(i, 3);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits = bits << 8 | (k < group.size() ? static_cast<unsigned char>(group[k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= group.size() ? digits[bits >> (18 - 6 * k) & 63U] : '=';
    }
  }
  return text;
}

EmbeddedPicture embedded_picture(const std::filesystem::path& path, int side) {
  const Picture picture = thumbnail(path, side);
  const std::string png = imaging().encoded(picture, path.stem() += ".png");
  const std::string jpeg = imaging().encoded(picture, path.stem() += ".jpg");
  const bool is_flat = png.size() <= jpeg.size();
  return {
      (is_flat ? "data:image/png;base64," + base64(png) : "data:image/jpeg;base64," + base64(jpeg)),
      picture.width, picture.height};
}

}  // namespace collage
