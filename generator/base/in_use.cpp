#include "base/in_use.h"

#include <cerrno>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace collage {

namespace fs = std::filesystem;

bool hold(int descriptor) {
  while (::flock(descriptor, LOCK_EX) != 0 && errno == EINTR) {
  }
  struct stat info {};
  return ::fstat(descriptor, &info) == 0 && info.st_nlink > 0;
}

Abandoned::Abandoned(const fs::path& file)
    : descriptor_(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW)),
      is_ours_(descriptor_ >= 0 && ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) {}

Abandoned::~Abandoned() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
}

bool VisitedFolders::add(const fs::path& folder) {
  const std::lock_guard lock(mutex_);
  return folders_.insert(fs::absolute(folder)).second;
}

}  // namespace collage
