#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"
#include "geometry/mesh.h"

namespace collage {

/// The regular file that `name` means as seen from `folder`, where it lies inside that folder once
/// every ".." and symbolic link is followed; otherwise nothing. '\' counts as '/'. The path
/// returned begins with `folder` as given.
std::optional<std::filesystem::path> file_inside(const std::filesystem::path& folder,
                                                 std::string_view name);

struct MaterialFiles {
  std::vector<Material> materials;
  /// The MTL files read.
  std::vector<std::filesystem::path> files;
};

/// Reads what `mtllib` lines name: each a file whose name may hold blanks, or several names. Takes
/// Kd, Ks, Ns, d or 1 - Tr, Ni, Ke, Pr, Pm, Ps, Pc and map_Kd; of two materials with one name the
/// first counts. Kd is taken as sRGB, but as linear light where Blender wrote the file, as it says
/// in the first line. Numbers beyond their range are clamped; Ni = 1 counts as not given. Missing
/// files, and files and textures outside `folder`, are noted and left out.
MaterialFiles read_materials(const std::filesystem::path& folder,
                             const std::vector<std::string>& libraries, Status& status);

/// What MTL says of a material between its newmtl and its map_Kd, a line a value.
std::string material_text(const Material& material);

/// Replaces the triangles' indices into `names` (-1: none) by indices into mesh.materials, which it
/// fills with what the names mean in the order in which triangles use them. A name without a
/// definition is grey. Leaves the mesh without materials where `names` is empty.
void set_materials(const std::vector<std::string>& names, const std::vector<Material>& defined,
                   Mesh& mesh);

}  // namespace collage
