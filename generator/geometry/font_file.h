#pragma once

#include <filesystem>
#include <string>

namespace collage {

/// A font in a file that may hold several.
struct FontFile {
  std::filesystem::path path;
  /// As FreeType counts: the face in the low 16 bits, above them the named instance of a variable
  /// font from 1, or 0.
  long index = 0;
};

/// Whether `font` is the path of a file, by its ending: .ttf, .otf, .ttc or .otc.
bool is_font_path(const std::string& font);

/// The font of a path (see is_font_path()), which is taken as it is, or the installed one that is
/// called so: a family, and after colons the style, as fontconfig writes it, "DejaVu Sans",
/// "DejaVu Sans:bold", "Noto Serif:italic:weight=180"; hyphens and commas of families need no
/// backslash.
///
/// Nothing stands in for what is not there. Throws Error where the family is not installed, with
/// the nearest that is; where it is not installed in that style, with those that are; where `font`
/// is no pattern.
FontFile find_font(const std::string& font);

}  // namespace collage
