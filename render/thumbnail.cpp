#include "render/thumbnail.h"

#include <algorithm>
#include <cmath>

#include <OpenImageIO/color.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

namespace collage {
namespace {

/// A picture as three linear channels; of a grey one the first thrice. Alpha is left out.
Picture linear_rgb(const Picture& picture) {
  Picture rgb = picture;
  rgb.channels = 3;
  rgb.values.resize(picture.pixels() * 3);
  const auto channels = static_cast<std::size_t>(picture.channels);
  for (std::size_t pixel = 0; pixel < picture.pixels(); ++pixel) {
    for (std::size_t c = 0; c < 3; ++c) {
      const float value = picture.values[pixel * channels + (channels < 3 ? 0 : c)];
      rgb.values[pixel * 3 + c] =
          picture.format == PictureFormat::png ? OIIO::sRGB_to_linear(value) : value;
    }
  }
  return rgb;
}

int scaled(int length, double scale) {
  return std::max(1, static_cast<int>(std::lround(length * scale)));
}

Picture resized(Picture& picture, double scale) {
  Picture small;
  small.width = scaled(picture.width, scale);
  small.height = scaled(picture.height, scale);
  small.values.resize(small.pixels() * 3);
  const OIIO::ImageBuf from({picture.width, picture.height, 3, OIIO::TypeDesc::FLOAT},
                            picture.values.data());
  OIIO::ImageBuf to({small.width, small.height, 3, OIIO::TypeDesc::FLOAT}, small.values.data());
  OIIO::ImageBufAlgo::resize(to, from, "lanczos3");
  return small;
}

}  // namespace

Picture thumbnail(const std::filesystem::path& path, int side) {
  Picture picture = linear_rgb(read_picture(path));
  const double scale = static_cast<double>(side) / std::max(picture.width, picture.height);
  if (scale < 1.0) {
    picture = resized(picture, scale);
  }
  for (float& value : picture.values) {
    value = OIIO::linear_to_sRGB(std::clamp(value, 0.0F, 1.0F));  // lanczos3 may overshoot
  }
  picture.format = PictureFormat::png;
  picture.key.clear();
  return picture;
}

}  // namespace collage
