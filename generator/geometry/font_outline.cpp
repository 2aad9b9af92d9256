#include "geometry/font_outline.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include <fmt/format.h>
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"

namespace collage {
namespace {

constexpr std::uintmax_t largest_file_bytes = std::uintmax_t{256} << 20;
constexpr std::size_t longest_text = 200;
constexpr std::size_t most_points = 100000;
constexpr double farthest_point = 512.0;
constexpr double most_chords = 200.0;
constexpr double capital_of_em = 0.7;

constexpr const char* other_font = "choose another font";

std::u32string characters(std::string_view text) {
  std::u32string result;
  while (!text.empty()) {
    const auto character = take_character(text);
    if (!character) {
      throw Error("the text for letters is not UTF-8", "write it as UTF-8");
    }
    if (*character < 0x20 || (*character >= 0x7F && *character < 0xA0)) {
      throw Error(fmt::format("the text for letters holds the control character U+{:04X}",
                              static_cast<std::uint32_t>(*character)),
                  "leave it out");
    }
    result += *character;
  }
  if (result.size() > longest_text) {
    throw Error(fmt::format("the text for letters has {} characters", result.size()),
                fmt::format("shorten it to {}", longest_text));
  }
  return result;
}

/// Makes contours of the curves that FreeType hands over one by one.
class Pen {
 public:
  Pen(double scale, double tolerance) : scale_(scale), tolerance_(tolerance) {}

  void start_at(const dvec2& origin) { origin_ = origin; }
  /// False where there are more or farther points than letters have.
  bool draw(FT_Outline& outline) {
    FT_Outline_Funcs functions{};
    functions.move_to = [](const FT_Vector* to, void* pen) { return of(pen).move(*to); };
    functions.line_to = [](const FT_Vector* to, void* pen) { return of(pen).line(*to); };
    functions.conic_to = [](const FT_Vector* by, const FT_Vector* to, void* pen) {
      return of(pen).conic(*by, *to);
    };
    functions.cubic_to = [](const FT_Vector* first, const FT_Vector* second, const FT_Vector* to,
                            void* pen) { return of(pen).cubic(*first, *second, *to); };
    return FT_Outline_Decompose(&outline, &functions, this) == 0;
  }
  [[nodiscard]] std::vector<Contour> contours() const { return contours_; }

 private:
  static Pen& of(void* pen) { return *static_cast<Pen*>(pen); }

  [[nodiscard]] dvec2 place(const FT_Vector& point) const {
    return origin_ + scale_ * dvec2(static_cast<double>(point.x), static_cast<double>(point.y));
  }
  /// What FreeType goes on or stops by.
  int add(const dvec2& point) {
    contours_.back().push_back(point);
    const bool too_much = ++points_ > most_points || !(std::abs(point.x) < farthest_point) ||
                          !(std::abs(point.y) < farthest_point);
    return too_much ? 1 : 0;
  }
  int move(const FT_Vector& to) {
    contours_.emplace_back();
    return add(place(to));
  }
  int line(const FT_Vector& to) { return add(place(to)); }

  int conic(const FT_Vector& by, const FT_Vector& to) {
    const dvec2 a = contours_.back().back();
    const dvec2 b = place(by);
    const dvec2 c = place(to);
    return chords(glm::length(a - 2.0 * b + c) / 4.0, [&](double t) {
      return (1 - t) * (1 - t) * a + 2 * t * (1 - t) * b + t * t * c;
    });
  }
  int cubic(const FT_Vector& first, const FT_Vector& second, const FT_Vector& to) {
    const dvec2 a = contours_.back().back();
    const dvec2 b = place(first);
    const dvec2 c = place(second);
    const dvec2 d = place(to);
    const double bend = std::max(glm::length(a - 2.0 * b + c), glm::length(b - 2.0 * c + d));
    return chords(0.75 * bend, [&](double t) {
      const double s = 1 - t;
      return s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
    });
  }
  /// As many chords of a curve as keep to the tolerance; one is off by `deviation`, n by its n²-th
  /// part.
  template <class Curve>
  int chords(double deviation, const Curve& curve) {
    const double wanted = std::ceil(std::sqrt(deviation / tolerance_));
    const int count = static_cast<int>(std::clamp(wanted, 1.0, most_chords));
    for (int i = 1; i <= count; ++i) {
      if (add(curve(static_cast<double>(i) / count)) != 0) {
        return 1;
      }
    }
    return 0;
  }

  double scale_;
  double tolerance_;
  dvec2 origin_{0.0};
  std::size_t points_ = 0;
  std::vector<Contour> contours_;
};

/// A font that FreeType has opened, from memory, since it would open devices as well.
class Face {
 public:
  explicit Face(const FontFile& font)
      : path_(font.path), content_(read_file(font.path, largest_file_bytes)) {
    if (FT_Init_FreeType(&library_) != 0) {
      throw Error("FreeType cannot be started", "check the installation of libfreetype6");
    }
    const auto* bytes = reinterpret_cast<const FT_Byte*>(content_.data());
    if (FT_New_Memory_Face(library_, bytes, static_cast<FT_Long>(content_.size()), font.index,
                           &face_) != 0) {
      FT_Done_FreeType(library_);
      refuse("is not a font that can be read", "check the file, or choose another font");
    }
  }
  ~Face() {
    FT_Done_Face(face_);
    FT_Done_FreeType(library_);
  }
  Face(const Face&) = delete;
  Face& operator=(const Face&) = delete;

  [[noreturn]] void refuse(const std::string& problem, const std::string& remedy) const {
    throw Error({path_}, problem, remedy);
  }

  void require_outlines() const {
    if (!FT_IS_SCALABLE(face_)) {
      refuse("holds pictures of letters, not their outlines", "choose a font with outlines");
    }
    if (face_->charmap == nullptr || face_->units_per_EM == 0) {
      refuse("does not say which glyph stands for which character", other_font);
    }
  }

  /// Height of an H in the font's units.
  double capital_height() const {
    const FT_UInt h = FT_Get_Char_Index(face_, U'H');
    FT_BBox box{};
    if (h != 0 && FT_Load_Glyph(face_, h, FT_LOAD_NO_SCALE) == 0 &&
        face_->glyph->format == FT_GLYPH_FORMAT_OUTLINE) {
      FT_Outline_Get_CBox(&face_->glyph->outline, &box);
    }
    return box.yMax > 0 ? static_cast<double>(box.yMax) : capital_of_em * face_->units_per_EM;
  }

  /// The glyph, loaded. Throws where there is none or it is no outline.
  FT_GlyphSlot glyph(char32_t character, FT_UInt index) const {
    const auto code = static_cast<std::uint32_t>(character);
    if (index == 0) {
      refuse(fmt::format("has no glyph for U+{:04X}", code),
             fmt::format("choose a font that has; `fc-list :charset={:x}` lists them", code));
    }
    const bool loaded = FT_Load_Glyph(face_, index, FT_LOAD_NO_SCALE) == 0 &&
                        face_->glyph->format == FT_GLYPH_FORMAT_OUTLINE;
    const bool is_picture =
        loaded && face_->glyph->outline.n_points == 0 && FT_HAS_COLOR(face_) && character != U' ';
    if (!loaded || is_picture) {
      refuse(fmt::format("has no outline for U+{:04X}", code), other_font);
    }
    return face_->glyph;
  }

  FT_UInt index_of(char32_t character) const { return FT_Get_Char_Index(face_, character); }
  /// By how much the second glyph moves, in the font's units.
  double kerning(FT_UInt left, FT_UInt right) const {
    FT_Vector move{};
    FT_Get_Kerning(face_, left, right, FT_KERNING_UNSCALED, &move);
    return static_cast<double>(move.x);
  }

 private:
  std::filesystem::path path_;
  std::string content_;
  FT_Library library_ = nullptr;
  FT_Face face_ = nullptr;
};

}  // namespace

std::vector<Contour> read_outlines(const FontFile& font, std::string_view text, double tolerance) {
  const std::u32string wanted = characters(text);
  const Face face(font);
  face.require_outlines();
  const double scale = 1.0 / face.capital_height();
  Pen pen(scale, tolerance);
  double x = 0.0;
  FT_UInt previous = 0;
  for (const char32_t character : wanted) {
    const FT_UInt index = face.index_of(character);
    const FT_GlyphSlot glyph = face.glyph(character, index);
    x += face.kerning(previous, index);
    pen.start_at({scale * x, 0.0});
    if (!pen.draw(glyph->outline)) {
      face.refuse("makes letters of more points, or larger ones, than can be used",
                  "shorten the text, or choose another font");
    }
    x += static_cast<double>(glyph->advance.x);
    previous = index;
  }
  return pen.contours();
}

}  // namespace collage
