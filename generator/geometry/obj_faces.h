#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/obj_text.h"

namespace collage {

/// What a corner of an OBJ face names, counted from 0; `none` for no uv or normal. May lie outside
/// the lists it means.
struct ObjCorner {
  static constexpr std::int64_t none = -1;
  std::int64_t position;
  std::int64_t uv;
  std::int64_t normal;
};

/// The faces of an OBJ text as written, none checked.
struct ObjFaces {
  std::vector<dvec3> normals;
  std::vector<dvec2> uvs;
  /// Face f has the corners from starts[f] to before starts[f + 1], and stands on line
  /// ObjText::face_lines[f].
  std::vector<ObjCorner> corners;
  std::vector<std::size_t> starts{0};
  /// Index into `material_names`, or -1 ahead of the first `usemtl`.
  std::vector<int> materials;
  std::vector<std::string> material_names;

  [[nodiscard]] std::size_t size() const { return materials.size(); }
};

/// Reads the faces by tinyobjloader. Cost: O(length of the text).
ObjFaces parse_faces(const ObjText& text);

}  // namespace collage
