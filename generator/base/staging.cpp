#include "base/staging.h"

#include <algorithm>
#include <system_error>
#include <vector>

#include "base/error.h"
#include "base/file.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_below(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      files.push_back(entry.path().lexically_relative(folder));
    }
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace

Staging::Staging(const fs::path& folder) : folder_(folder), staged_(folder / ".collage-new") {
  std::error_code error;
  fs::remove_all(staged_, error);
  fs::create_directories(staged_, error);
  if (error) {
    throw Error({folder_}, "cannot be written to: " + error.message(),
                "check the folder's permissions and free space, or choose another with -o");
  }
}

Staging::~Staging() {
  std::error_code ignored;
  fs::remove_all(staged_, ignored);
}

void Staging::commit() {
  const std::vector<fs::path> files = files_below(staged_);
  for (const fs::path& file : files) {
    require_replaceable(folder_ / file);
    make_folders((folder_ / file).parent_path());
  }
  for (const fs::path& file : files) {
    move_into_place(staged_ / file, folder_ / file);
  }
}

}  // namespace collage
