#include "geometry/font_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <memory>
#include <set>
#include <span>
#include <string_view>

#include <fmt/format.h>
#include <fontconfig/fontconfig.h>
#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

#include "base/error.h"

namespace collage {
namespace {

constexpr std::size_t longest_pattern = 200;

struct Deleter {
  void operator()(FcPattern* pattern) const { FcPatternDestroy(pattern); }
  void operator()(FcObjectSet* objects) const { FcObjectSetDestroy(objects); }
  void operator()(FcFontSet* fonts) const { FcFontSetDestroy(fonts); }
};
using Pattern = std::unique_ptr<FcPattern, Deleter>;

std::string text_of(const FcPattern* pattern, const char* object, int index = 0) {
  FcChar8* text = nullptr;
  return FcPatternGetString(pattern, object, index, &text) == FcResultMatch
             ? reinterpret_cast<const char*>(text)
             : "";
}

/// What is a size or a list of families for fontconfig is a part of the name for us.
std::string with_plain_family(const std::string& font) {
  std::string result;
  bool in_family = true;
  bool escaped = false;
  for (const char c : font) {
    in_family = in_family && (escaped || c != ':');
    if (in_family && !escaped && (c == '-' || c == ',')) {
      result += '\\';
    }
    escaped = !escaped && c == '\\';
    result += c;
  }
  return result;
}

FontFile file_of(const FcPattern* pattern) {
  int index = 0;
  FcPatternGetInteger(pattern, FC_INDEX, 0, &index);
  return {text_of(pattern, FC_FILE), index};
}

/// Does nothing but the first time.
bool start_fontconfig() {
#ifdef __SANITIZE_ADDRESS__
  const __lsan::ScopedDisabler disabler;  // it never frees some of its configuration
#endif
  return FcInit() == FcTrue;
}

/// What fontconfig knows of the fonts that are installed.
class Installed {
 public:
  Installed() {
    if (!start_fontconfig()) {
      throw Error("fontconfig cannot be started", "run: apt-get install fontconfig-config");
    }
  }

  /// The fonts that have all that the pattern asks for.
  [[nodiscard]] std::span<FcPattern* const> list(FcPattern* pattern) {
    const std::unique_ptr<FcObjectSet, Deleter> objects(
        FcObjectSetBuild(FC_FAMILY, FC_STYLE, FC_FILE, FC_INDEX, nullptr));
    fonts_.reset(FcFontList(nullptr, pattern, objects.get()));
    return fonts_ == nullptr ? std::span<FcPattern* const>{}
                             : std::span<FcPattern* const>(fonts_->fonts,
                                                           static_cast<std::size_t>(fonts_->nfont));
  }

  /// The font nearest to the pattern, whatever that is.
  [[nodiscard]] FontFile best(const FcPattern* pattern) const {
    const Pattern wish(FcPatternDuplicate(pattern));
    FcConfigSubstitute(nullptr, wish.get(), FcMatchPattern);
    FcDefaultSubstitute(wish.get());
    FcResult result = FcResultNoMatch;
    const Pattern match(FcFontMatch(nullptr, wish.get(), &result));
    return match == nullptr ? FontFile{} : file_of(match.get());
  }

 private:
  std::unique_ptr<FcFontSet, Deleter> fonts_;
};

Pattern pattern_of_family(const std::string& family) {
  Pattern pattern(FcPatternCreate());
  FcPatternAddString(pattern.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family.c_str()));
  return pattern;
}

[[noreturn]] void refuse_family(Installed& installed, const std::string& family) {
  const Pattern any(FcPatternCreate());
  std::set<std::string> families;
  for (const FcPattern* font : installed.list(any.get())) {
    families.insert(text_of(font, FC_FAMILY));
  }
  const std::string guess = did_you_mean(family, families);
  throw Error("the font family '" + family + "' is not installed",
              guess.empty() ? "`fc-list : family` lists those that are" : guess);
}

[[noreturn]] void refuse_style(Installed& installed, const std::string& family,
                               const std::string& font) {
  std::set<std::string> styles;
  for (const FcPattern* found : installed.list(pattern_of_family(family).get())) {
    styles.insert(text_of(found, FC_STYLE));
  }
  throw Error("the font '" + font + "' is not installed in that style",
              fmt::format("its styles are {}", fmt::join(styles, ", ")));
}

}  // namespace

bool is_font_path(const std::string& font) {
  std::string ending = std::filesystem::path(font).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  constexpr std::array<std::string_view, 4> endings{".ttf", ".otf", ".ttc", ".otc"};
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

FontFile find_font(const std::string& font) {
  if (is_font_path(font)) {
    return {font, 0};
  }
  const bool plain =
      font.size() <= longest_pattern &&
      std::none_of(font.begin(), font.end(), [](unsigned char c) { return std::iscntrl(c) != 0; });
  const std::string name = with_plain_family(font);
  const Pattern pattern(plain ? FcNameParse(reinterpret_cast<const FcChar8*>(name.c_str()))
                              : nullptr);
  const std::string family = pattern == nullptr ? "" : text_of(pattern.get(), FC_FAMILY);
  if (family.empty()) {
    throw Error("'" + font.substr(0, longest_pattern) + "' does not name a font",
                "write a family, as \"DejaVu Sans\" or \"DejaVu Sans:bold\", or the path of a .ttf "
                "or .otf file");
  }
  FcPatternAddBool(pattern.get(), FC_VARIABLE, FcFalse);  // their named instances are fonts, too
  Installed installed;
  if (installed.list(pattern_of_family(family).get()).empty()) {
    refuse_family(installed, family);
  }
  const FontFile best = installed.best(pattern.get());
  const auto fonts = installed.list(pattern.get());
  const bool is_asked_for = std::any_of(fonts.begin(), fonts.end(), [&](const FcPattern* found) {
    const FontFile file = file_of(found);
    return file.path == best.path && file.index == best.index;
  });
  return is_asked_for ? best : (refuse_style(installed, family, font), best);
}

}  // namespace collage
