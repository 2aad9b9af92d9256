#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "geometry/mesh.h"

namespace collage {

/// The geometry of a scene.pov as write_povray() lays it out, read back for the audit.
struct PovrayScene {
  /// The matrix is three columns and the translation.
  struct Instance {
    /// In the order of placement.
    std::size_t number = 0;
    std::uint32_t element = 0;
    std::array<double, 12> matrix{};
    int line = 0;
  };
  /// By name, "Target" and "Element_0" and up: positions and triangles of each mesh2.
  std::map<std::string, Mesh> meshes;
  /// In the order of their lines.
  std::vector<Instance> instances;
};

/// Throws Error with the line where the file is missing or a mesh2 or the union of instances holds
/// anything that write_povray() does not write.
PovrayScene read_povray(const std::filesystem::path& path);

}  // namespace collage
