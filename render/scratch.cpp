#include "render/scratch.h"

#include <atomic>
#include <cerrno>
#include <mutex>
#include <set>
#include <string_view>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"

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

/// Whether this process comes to the folder for the first time.
bool is_first_visit(const fs::path& folder) {
  static std::mutex mutex;
  static std::set<fs::path> seen;
  const std::lock_guard lock(mutex);
  return seen.insert(fs::absolute(folder)).second;
}

}  // namespace

Scratch::Scratch(const fs::path& folder) : folder_(folder) {
  static std::atomic<unsigned> counter{0};
  std::error_code ignored;  // a folder that cannot be made is reported by open() below
  fs::create_directories(folder, ignored);
  if (is_first_visit(folder)) {
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
  // A clean-up that came between the two calls has taken the file away. Where the file system knows
  // no locks, there is no clean-up either.
  while (::flock(descriptor_, LOCK_EX) != 0 && errno == EINTR) {
  }
  struct stat info {};
  if (::fstat(descriptor_, &info) == 0 && info.st_nlink > 0) {
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
    const int descriptor = ::open((folder / (stem + lock_extension)).c_str(), O_RDWR | O_CLOEXEC);
    if (descriptor < 0) {
      continue;
    }
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) {
      remove_files(folder, stem);
    }
    ::close(descriptor);
  }
}

}  // namespace collage
