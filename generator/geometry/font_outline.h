#pragma once

#include <string_view>
#include <vector>

#include "geometry/font_file.h"
#include "geometry/planar_region.h"

namespace collage {

/// The outlines of a line of text: contours as the font has them, which may overlap; what they wind
/// round other than zero times is ink. A capital letter, H, is 1 high (a font without H: 0.7 of its
/// em); the text starts at x = 0 and stands on y = 0. Glyphs follow each other from left to right
/// at the font's advances and by its kern table; ligatures and the scripts that join letters take
/// a shaper, which this is not. Curves become chords no farther from them than `tolerance`, as many
/// as Wang's formula asks for (Wang 1984; Goldman 2003, "Pyramid Algorithms").
///
/// Throws Error where the text is not UTF-8, longer than 200 characters, or holds control
/// characters; where the font has no glyph for one, which is named (U+00E4); where the font cannot
/// be read, holds pictures instead of outlines, or is larger than letters are (a file of 256 MiB,
/// 100,000 points, a text 512 wide).
std::vector<Contour> read_outlines(const FontFile& font, std::string_view text, double tolerance);

}  // namespace collage
