#pragma once

#include <filesystem>

#include "scene/mesh_library.h"

namespace collage {

/// Where the program may look for its templates and scenes; empty: not there to be looked at.
struct DataPlaces {
  std::filesystem::path wish;        // the environment's COLLAGE_DATA
  std::filesystem::path executable;  // the running program, links resolved
  std::filesystem::path source;      // the folder that the program was built from
};

/// The places of the running program.
DataPlaces data_places();

/// The folder that holds `templates/` and `scenes/`: the user's wish, else ../share/collage as seen
/// from the program's folder (wherever it was installed), else the sources it was built from.
/// Throws Error where there is none; a wish without `templates/` is an error, not passed over.
std::filesystem::path data_folder(const DataPlaces& places);

/// The libraries in the folder that the environment's COLLAGE_MESHES names, none where it is not
/// set. Throws as data_folder() does.
MeshLibraries mesh_libraries();

}  // namespace collage
