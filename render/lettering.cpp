#include "render/lettering.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <array>
#include <filesystem>
#include <vector>

#include "base/error.h"
#include "base/text.h"

namespace collage {
namespace {

constexpr std::array font_places = {
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
    "/usr/share/fonts/TTF/DejaVuSans.ttf",
};

constexpr char32_t not_a_character = 0xFFFD;
constexpr std::string_view ellipsis = "…";

const char* font_file() {
  const auto* const found = std::ranges::find_if(
      font_places, [](const char* place) { return std::filesystem::exists(place); });
  if (found == font_places.end()) {
    throw Error("captions need the font DejaVu Sans, which is not installed",
                "run: apt-get install fonts-dejavu-core");
  }
  return *found;
}

/// Takes one character off the front of the text, one that can be shown.
char32_t next_character(std::string_view& text) {
  const char32_t character = take_character(text).value_or(not_a_character);
  return character < 0x20 ? U' ' : character;
}

/// The lengths in bytes of the text's first 0, 1, 2, … characters.
std::vector<std::size_t> prefixes(std::string_view text) {
  std::vector<std::size_t> lengths = {0};
  for (std::string_view rest = text; !rest.empty();) {
    next_character(rest);
    lengths.push_back(text.size() - rest.size());
  }
  return lengths;
}

struct FreeType {
  FT_Library library = nullptr;
  FreeType() { FT_Init_FreeType(&library); }
  ~FreeType() { FT_Done_FreeType(library); }
  FreeType(const FreeType&) = delete;
  FreeType& operator=(const FreeType&) = delete;
};

void blend(Picture& picture, const FT_Bitmap& glyph, int left, int top, float grey) {
  const int x_end = std::min<int>(static_cast<int>(glyph.width), picture.width - left);
  const int y_end = std::min<int>(static_cast<int>(glyph.rows), picture.height - top);
  for (int y = std::max(0, -top); y < y_end; ++y) {
    for (int x = std::max(0, -left); x < x_end; ++x) {
      const float cover = static_cast<float>(glyph.buffer[y * glyph.pitch + x]) / 255.0F;
      const auto pixel =
          static_cast<std::size_t>(top + y) * static_cast<std::size_t>(picture.width) +
          static_cast<std::size_t>(left + x);
      for (int c = 0; c < picture.channels; ++c) {
        float& value = picture.values[pixel * static_cast<std::size_t>(picture.channels) +
                                      static_cast<std::size_t>(c)];
        value += cover * (grey - value);
      }
    }
  }
}

}  // namespace

struct Lettering::Face {
  FreeType freetype;
  FT_Face face = nullptr;

  Face() = default;
  ~Face() { FT_Done_Face(face); }
  Face(const Face&) = delete;
  Face& operator=(const Face&) = delete;

  /// Goes through the text with a pen that starts at `left`: on_glyph(slot, x in pixels). Returns
  /// where the pen ends, in 1/64 pixels as FreeType counts.
  template <class OnGlyph>
  FT_Pos walk(std::string_view text, int left, FT_Int32 flags, const OnGlyph& on_glyph) const {
    FT_Pos pen = FT_Pos{left} * 64;
    FT_UInt previous = 0;
    while (!text.empty()) {
      const FT_UInt glyph = FT_Get_Char_Index(face, next_character(text));
      FT_Vector kerning{};
      FT_Get_Kerning(face, previous, glyph, FT_KERNING_DEFAULT, &kerning);
      pen += kerning.x;
      previous = glyph;
      if (FT_Load_Glyph(face, glyph, flags) == 0) {
        on_glyph(*face->glyph, static_cast<int>(pen / 64));
        pen += face->glyph->advance.x;
      }
    }
    return pen;
  }
};

Lettering::Lettering(int size) : face_(std::make_unique<Face>()) {
  const char* const file = font_file();
  if (FT_New_Face(face_->freetype.library, file, 0, &face_->face) != 0 ||
      FT_Set_Pixel_Sizes(face_->face, 0, static_cast<FT_UInt>(size)) != 0) {
    throw Error({file}, "is not a font that can be read",
                "run: apt-get install --reinstall fonts-dejavu-core");
  }
}

Lettering::~Lettering() = default;
Lettering::Lettering(Lettering&&) noexcept = default;
Lettering& Lettering::operator=(Lettering&&) noexcept = default;

int Lettering::width(std::string_view text) const {
  const FT_Pos end = face_->walk(text, 0, FT_LOAD_TARGET_LIGHT, [](const FT_GlyphSlotRec&, int) {});
  return static_cast<int>((end + 63) / 64);
}

std::string Lettering::fitted(std::string_view text, int width_) const {
  if (width(text) <= width_) {
    return std::string(text);
  }
  const std::vector<std::size_t> lengths = prefixes(text);
  const auto shortened = [&](std::size_t length) {
    return std::string(text.substr(0, length)) + std::string(ellipsis);
  };
  const auto too_long = std::ranges::partition_point(
      lengths, [&](std::size_t length) { return width(shortened(length)) <= width_; });
  const std::size_t length = too_long == lengths.begin() ? 0 : *std::prev(too_long);
  return shortened(text.substr(0, length).find_last_not_of(' ') + 1);
}

void Lettering::write(Picture& picture, int left, int baseline, std::string_view text,
                      float grey) const {
  face_->walk(
      text, left, FT_LOAD_RENDER | FT_LOAD_TARGET_LIGHT, [&](const FT_GlyphSlotRec& glyph, int x) {
        blend(picture, glyph.bitmap, x + glyph.bitmap_left, baseline - glyph.bitmap_top, grey);
      });
}

}  // namespace collage
