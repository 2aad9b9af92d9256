#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "geometry/planar_region.h"

namespace collage {

/// Letters, digits, signs, with accents, of other scripts, and blocks.
inline std::vector<std::string> some_characters() {
  std::vector<std::string> characters;
  for (char c = '!'; c <= '~'; ++c) {
    characters.emplace_back(1, c);
  }
  for (const char* c : {"Ä", "ö", "ß", "é", "Å", "Ç", "ø", "Œ", "ñ", "Ω",
                        "Ж", "ф", "€", "©", "½", "…", "∞", "▚", "█", "◎"}) {
    characters.emplace_back(c);
  }
  return characters;
}

/// Where the contours cross the line at height y, and which way they go on there.
inline std::vector<std::pair<double, int>> crossings(const std::vector<Contour>& contours,
                                                     double y) {
  std::vector<std::pair<double, int>> result;
  for (const Contour& contour : contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const dvec2 a = contour[i];
      const dvec2 b = contour[(i + 1) % contour.size()];
      if ((a.y <= y) != (b.y <= y)) {
        result.emplace_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x), a.y <= y ? 1 : -1);
      }
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// The area of what is wound round other than zero times, line by line.
inline double inked_area(const std::vector<Contour>& contours, int lines) {
  Box box;
  for (const Contour& contour : contours) {
    for (const dvec2& point : contour) {
      box.include({point, 0.0});
    }
  }
  const double step = box.extent().y / lines;
  double length = 0.0;
  for (int line = 0; line < lines; ++line) {
    int winding = 0;
    double left = 0.0;
    for (const auto& [x, turn] : crossings(contours, box.min.y + (line + 0.5) * step)) {
      length += winding != 0 ? x - left : 0.0;
      winding += turn;
      left = x;
    }
  }
  return step * length;
}

}  // namespace collage
