#pragma once

#include <filesystem>
#include <string>

#include "base/error.h"

namespace collage {

/// Collections of meshes that do not come along with scenes. A scene names a mesh of one as
/// "LIBRARY:PATH", the path starting from the library's folder: "sweethome3d-furniture:scopia/
/// rabbit/rabbit.obj".
struct MeshLibraries {
  /// Holds a folder for each library, of the library's name; empty: there are none.
  std::filesystem::path folder;
  /// How to get those that are missing, for messages.
  std::string remedy;
};

/// Whether the text names a mesh of a library: letters, digits, '-', '_' and '.' before its first
/// ':'. A file of such a name is written "./NAME".
bool names_library(const std::string& text);

/// The file that "LIBRARY:PATH" means. Throws Error, whose message begins with `subject`, where the
/// library is not there, or the path does not lead to a regular file inside of its folder, every
/// ".." and symbolic link followed.
std::filesystem::path find_in_library(const std::string& text, const MeshLibraries& libraries,
                                      const Place& place, const std::string& subject);

}  // namespace collage
