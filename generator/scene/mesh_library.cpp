#include "scene/mesh_library.h"

#include <algorithm>
#include <cctype>

#include "geometry/material_file.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

bool may_be_in_a_name(unsigned char c) {
  return c < 0x80 && (std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.');
}

}  // namespace

bool names_library(const std::string& text) {
  const std::size_t colon = text.find(':');
  return colon != std::string::npos && colon > 0 && text[0] != '.' &&
         std::all_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(colon),
                     may_be_in_a_name);
}

fs::path find_in_library(const std::string& text, const MeshLibraries& libraries,
                         const Place& place, const std::string& subject) {
  const std::size_t colon = text.find(':');
  const std::string name = text.substr(0, colon);
  const std::string path = text.substr(colon + 1);
  const fs::path folder = libraries.folder / name;
  std::error_code ignored;  // what cannot be looked at does not exist for us
  if (libraries.folder.empty() || !fs::is_directory(folder, ignored)) {
    throw Error(place, subject + ": there is no mesh library '" + name + "'", libraries.remedy);
  }
  const auto file = file_inside(folder, path);
  if (!file) {
    throw Error(place, subject + ": the mesh library '" + name + "' has no file '" + path + "'",
                "check the path, which starts from the library's folder " + folder.string());
  }
  return *file;
}

}  // namespace collage
