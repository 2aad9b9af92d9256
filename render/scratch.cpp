#include "render/scratch.h"

#include <atomic>
#include <cerrno>
#include <string_view>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include "base/error.h"
#include "base/in_use.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view prefix = ".collage-";
const char* const lock_extension = ".lock";

/// Files "<stem>.…", the lock last: as long as it is there, a killed clean-up can be taken up.
void remove_files(const fs::path& folder, const std::string& stem) {
  std::error_code ignored;
  std::vector<fs::path> doomed;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(stem + ".") && name != stem + lock_extension) {
      doomed.push_back(entry.path());
    }
  }
  for (const fs::path& path : doomed) {
    fs::remove(path, ignored);
  }
  fs::remove(folder / (stem + lock_extension), ignored);
}

std::vector<std::string> stems_in(const fs::path& folder) {
  std::error_code ignored;
  std::vector<std::string> stems;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    const fs::path name = entry.path().filename();
    if (name.extension() == lock_extension && name.string().starts_with(prefix)) {
      stems.push_back(name.stem().string());
    }
  }
  return stems;
}

}  // namespace

Scratch::Scratch(const fs::path& folder) : folder_(folder) {
  static std::atomic<unsigned> counter{0};
  std::error_code ignored;  // a folder that cannot be made is reported by open() below
  fs::create_directories(folder, ignored);
  static VisitedFolders visited;
  if (visited.add(folder)) {
    remove_stale_scratch(folder);
  }
  do {
    stem_ = std::string(prefix) + std::to_string(::getpid()) + "-" + std::to_string(counter++);
  } while (!lock());
}

bool Scratch::lock() {
  const fs::path path = folder_ / name(lock_extension);
  descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor_ < 0 && errno == EEXIST) {
    return false;
  }
  if (descriptor_ < 0) {
    throw Error({folder_}, "cannot be written to: " + std::generic_category().message(errno),
                "check the folder's permissions and free space, or choose another with -o");
  }
  // A clean-up that came between the two calls has taken the file away.
  if (hold(descriptor_)) {
    return true;
  }
  ::close(descriptor_);
  return false;
}

Scratch::~Scratch() {
  remove_files(folder_, stem_);
  ::close(descriptor_);
}

void remove_stale_scratch(const fs::path& folder) {
  for (const std::string& stem : stems_in(folder)) {
    if (const Abandoned abandoned(folder / (stem + lock_extension)); abandoned) {
      remove_files(folder, stem);
    }
  }
}

}  // namespace collage
