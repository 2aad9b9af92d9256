#include "cli/data_folder.h"

#include <cstdlib>
#include <system_error>

#include "base/error.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

bool holds_data(const fs::path& folder) {
  std::error_code ignored;  // a folder that cannot be looked into holds nothing for us
  return !folder.empty() && fs::is_directory(folder / "templates", ignored);
}

/// "" where the variable is not set.
std::string environment(const char* variable) {
  const char* value = std::getenv(variable);
  return value == nullptr ? "" : value;
}

}  // namespace

DataPlaces data_places() {
  DataPlaces places;
  places.wish = environment("COLLAGE_DATA");
  std::error_code ignored;  // without /proc the other places remain
  places.executable = fs::read_symlink("/proc/self/exe", ignored);
  places.source = COLLAGE_SOURCE_FOLDER;
  return places;
}

fs::path data_folder(const DataPlaces& places) {
  if (!places.wish.empty()) {
    if (!holds_data(places.wish)) {
      throw Error({places.wish}, "has no folder 'templates'",
                  "set COLLAGE_DATA to the folder that holds collage's templates and scenes");
    }
    return places.wish;
  }
  if (!places.executable.empty()) {
    const fs::path prefix = places.executable.parent_path().parent_path();
    if (holds_data(prefix / "share" / "collage")) {
      return prefix / "share" / "collage";
    }
  }
  if (holds_data(places.source)) {
    return places.source;
  }
  throw Error("collage's templates and scenes are not found",
              "install it again, or set COLLAGE_DATA to the folder that holds them");
}

MeshLibraries mesh_libraries() {
  const fs::path unpack = data_folder(data_places()) / "scenes" / "unpack-furniture";
  return {environment("COLLAGE_MESHES"),
          "set COLLAGE_MESHES to a folder that holds one of this name; sweethome3d-furniture is "
          "got by: apt-get install sweethome3d-furniture unzip && " +
              unpack.string() + " ~/meshes && export COLLAGE_MESHES=~/meshes"};
}

}  // namespace collage
