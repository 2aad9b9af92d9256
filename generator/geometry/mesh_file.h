#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "base/status.h"
#include "geometry/mesh.h"

namespace collage {

struct MeshFile {
  Mesh mesh;
  /// The OBJ, and the MTL files and textures that it uses.
  std::vector<std::filesystem::path> files;
};

/// Reads a Wavefront OBJ: polygons of any shape (triangulated), groups and objects (merged),
/// relative indices, normals, uv, materials. Free-form curves, lines, points and unknown keywords
/// are passed over. Positions that no triangle uses are dropped, so are triangles without area,
/// which is noted.
///
/// Normals are unit vectors; triangles without get their face's, unless none has any. Triangles
/// without uv get (0, 0), unless none has any. Materials: see read_materials(); those that no MTL
/// file defines are grey.
///
/// Throws Error, with the line where one is to blame: the file is missing, not a regular file,
/// larger than 2 GiB or not text; a face names a vertex that is not there; a vertex in use has a
/// coordinate that is not a finite number or beyond 1e18; there is no face with an area.
///
/// Cost: O(file size), besides triangulate().
MeshFile read_obj(const std::filesystem::path& path, Status& status);

/// Writes an OBJ and, where the mesh has materials, an MTL of the same name beside it. Numbers are
/// the shortest that read back the same. Each line of `header_comment` becomes a comment on top.
/// Textures are named relative to the folder of `path`. Throws Error as write_file() does.
void write_obj(const std::filesystem::path& path, const Mesh& mesh,
               std::string_view header_comment);

}  // namespace collage
