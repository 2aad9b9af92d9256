#pragma once

#include <optional>
#include <string>

#include "base/status.h"
#include "geometry/mesh.h"

namespace collage {

/// Letters as a solid. Lengths are fractions of the height of a capital letter.
struct LetterOptions {
  /// UTF-8; see read_outlines().
  std::string string;
  /// See find_font().
  std::string font = "DejaVu Sans:bold";
  double depth = 0.5;
  double bevel = 0.0;
};

/// The letters cut out of a slab: a capital is 1 high, stands on y = 0 and faces +z; the slab lies
/// from -depth/2 to +depth/2. Its edges are cut off at 45 degrees by the bevel, front and back; a
/// part whose strokes are too thin for that has a smaller one, which is noted. Curves are within
/// 1/1000 of the font's. The mesh is closed, two-manifold and faces outwards, whatever the font:
/// one part for each part of the letters, whose strokes may overlap. Normals are smooth along
/// curves.
///
/// Throws Error as find_font() and read_outlines() do; where there is nothing but blanks; where an
/// outline crosses itself more often than letters do.
Mesh make_letters(const LetterOptions& options, Status& status);

}  // namespace collage
