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

}  // namespace

DataPlaces data_places() {
  DataPlaces places;
  const char* wish = std::getenv("COLLAGE_DATA");
  places.wish = wish == nullptr ? "" : wish;
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

}  // namespace collage
