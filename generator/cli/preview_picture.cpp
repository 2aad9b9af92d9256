#include "cli/preview_picture.h"

#include "base/error.h"
#include "geometry/color.h"
#include "render/thumbnail.h"

namespace collage {
namespace {

constexpr int texture_side = 512;

Texture decoded(const Picture& picture) {
  Texture texture{picture.width, picture.height, {}};
  texture.texels.reserve(picture.pixels());
  for (std::size_t pixel = 0; pixel < picture.pixels(); ++pixel) {
    const float* value = &picture.values[3 * pixel];
    texture.texels.emplace_back(linear_from_srgb({value[0], value[1], value[2]}));
  }
  return texture;
}

}  // namespace

PreviewShot preview_shot(const Shot& shot) {
  PreviewShot result;
  result.bearing = {shot.view.azimuth_degrees, shot.view.elevation_degrees};
  result.width = shot.width;
  result.height = shot.height;
  result.framing = shot.framing == Shot::Framing::all_round ? Framing::all_round : Framing::view;
  return result;
}

Picture encoded(const PreviewPicture& picture) {
  Picture result;
  result.width = picture.width;
  result.height = picture.height;
  result.values.reserve(result.pixels() * 3);
  for (const glm::vec3& pixel : picture.pixels) {
    const glm::vec3 color = srgb_from_linear(glm::clamp(pixel, 0.0F, 1.0F));
    result.values.insert(result.values.end(), {color.r, color.g, color.b});
  }
  return result;
}

TextureReader texture_reader(Status& status) {
  return [&status](const std::filesystem::path& path) -> std::optional<Texture> {
    try {
      return decoded(thumbnail(path, texture_side));
    } catch (const Error& error) {
      status.note(error.what());
      return std::nullopt;
    }
  };
}

}  // namespace collage
