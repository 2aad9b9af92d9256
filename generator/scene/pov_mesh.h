#pragma once

#include <string>
#include <vector>

#include "base/file.h"
#include "scene/element_look.h"

namespace collage {

/// How a mesh2 is textured: the names of declared textures, "Element_0_Material_1". With
/// by_triangle, triangle t has textures[Mesh::triangle_materials[t]]; else all have the first. No
/// texture where the list is empty.
struct MeshTextures {
  std::vector<std::string> textures;
  ElementLook::Assignment assignment = ElementLook::Assignment::all_the_first;
  /// Whether some texture looks up a picture: only then is the mesh's uv written, a third of the
  /// text.
  bool use_uv = false;
};

/// Appends "#declare <name> = mesh2 { … }" with the mesh's normals where it has them. It is
/// one mesh2 whatever its materials, as POV-Ray shares only meshes between copies. A normal of
/// length 0, which POV-Ray does not take, is written as straight up.
void append_mesh2(FileWriter& file, const std::string& name, const Mesh& mesh,
                  const MeshTextures& look);

}  // namespace collage
