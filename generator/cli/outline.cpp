#include "cli/outline.h"

#include <array>

#include "render/picture_file.h"

namespace collage {
namespace {

using Rgb = std::array<float, 3>;

Rgb color_of(SilhouettePicture::Pixel pixel) {
  switch (pixel) {
    case SilhouettePicture::Pixel::target:
      return {0.85F, 0.33F, 0.27F};
    case SilhouettePicture::Pixel::both:
      return {0.22F, 0.25F, 0.30F};
    case SilhouettePicture::Pixel::sculpture:
      return {0.20F, 0.45F, 0.85F};
    case SilhouettePicture::Pixel::neither:
      break;
  }
  return {0.96F, 0.95F, 0.93F};
}

}  // namespace

std::filesystem::path outline_path(const std::filesystem::path& folder) {
  return folder / "sheets" / "outline.png";
}

void write_outline(const std::filesystem::path& path, const SilhouettePicture& outline) {
  Picture picture;
  picture.width = outline.width;
  picture.height = outline.height;
  for (const SilhouettePicture::Pixel pixel : outline.pixels) {
    const Rgb color = color_of(pixel);
    picture.values.insert(picture.values.end(), color.begin(), color.end());
  }
  write_picture(path, picture);
}

}  // namespace collage
