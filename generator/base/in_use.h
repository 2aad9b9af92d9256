#pragma once

#include <filesystem>
#include <mutex>
#include <set>

namespace collage {

// Files that a process holds a lock on for as long as it works with them: one that nobody holds was
// left behind by a process that was killed. Where the file system knows no locks, nothing is ever
// taken for left behind.

/// Takes the lock on an open file. False where those who clear up were quicker and have removed it.
bool hold(int descriptor);

/// The lock on a file that may have been left behind, for as long as it is to be cleared up.
class Abandoned {
 public:
  /// Follows no links.
  explicit Abandoned(const std::filesystem::path& file);
  ~Abandoned();
  Abandoned(const Abandoned&) = delete;
  Abandoned& operator=(const Abandoned&) = delete;

  /// False where somebody holds it, or it is not there.
  explicit operator bool() const { return is_ours_; }

 private:
  int descriptor_;
  bool is_ours_ = false;
};

/// Folders that this process has come to. Clearing up once is enough: while it lives, what is left
/// behind there is not its own.
class VisitedFolders {
 public:
  /// True the first time. Safe to call from many threads.
  bool add(const std::filesystem::path& folder);

 private:
  std::mutex mutex_;
  std::set<std::filesystem::path> folders_;
};

}  // namespace collage
