#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/mesh.h"

namespace collage {

/// What an OBJ text says that tinyobjloader does not pass on: where things stand, and coordinates
/// as exactly as they are written (its own reader is some ulps off and takes "nan" for 0).
struct ObjText {
  /// The text with one kind of line end, lines continued by '\' joined (and made up for by empty
  /// ones, so that lines keep their numbers), and without comments and dangling slashes behind
  /// vertices and faces.
  std::string text;
  /// One a `v` line; NaN in all three where the line does not hold three finite numbers.
  std::vector<dvec3> positions;
  /// The line of each `v`, and of each `f` that names a corner, counted from 1.
  std::vector<int> position_lines;
  std::vector<int> face_lines;
  /// The first `f` with a number that does not fit an int, which tinyobjloader takes for another.
  std::optional<int> overflowing_face_line;
  /// What stands behind each `mtllib`, white space trimmed.
  std::vector<std::string> libraries;
};

/// Cost: one pass over the text.
ObjText scan_obj(std::string_view text);

/// Without white space at both ends.
std::string_view trimmed(std::string_view text);

}  // namespace collage
