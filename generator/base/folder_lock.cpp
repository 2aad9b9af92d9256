#include "base/folder_lock.h"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "base/error.h"
#include "base/file.h"

namespace collage {

namespace fs = std::filesystem;

FolderLock::FolderLock(const fs::path& folder, Kind kind) {
  if (kind == Kind::alone) {
    made_ = make_folders(folder);
  }
  descriptor_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  const int wanted = kind == Kind::alone ? LOCK_EX : LOCK_SH;
  if (descriptor_ >= 0 && ::flock(descriptor_, wanted | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(descriptor_);
    throw Error({folder}, "is being worked on by another collage",
                "wait for it to end, or choose another folder with -o");
  }
}

FolderLock::~FolderLock() {
  remove_empty_folders(made_);
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
}

}  // namespace collage
