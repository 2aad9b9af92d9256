#include "fuzz.h"

#include <cstdlib>
#include <fstream>

#include <unistd.h>

namespace collage::fuzz {
namespace {

namespace fs = std::filesystem;

/// In memory where the system has such a place; goes with the process.
struct Folder {
  fs::path path =
      (fs::is_directory("/dev/shm") ? fs::path("/dev/shm") : fs::temp_directory_path()) /
      ("collage-fuzz-" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
};

}  // namespace

fs::path file_with(std::string_view content, const std::string& name) {
  static const Folder folder;
  const fs::path path = folder.path / name;
  std::ofstream(path, std::ios::binary) << content;
  return path;
}

}  // namespace collage::fuzz
