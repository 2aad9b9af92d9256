#pragma once

#include <filesystem>
#include <vector>

namespace collage {

/// A folder that one process writes to, or several read from. The lock is on the folder itself,
/// leaves no file behind and goes with the process, however that ends. Where the file system knows
/// no locks, there is none.
class FolderLock {
 public:
  enum class Kind { alone, shared };

  /// With `alone`, makes the folder where it is missing. Throws Error where it cannot be made, or
  /// another process has it: alone, or at all for one who wants it alone.
  FolderLock(const std::filesystem::path& folder, Kind kind);
  /// Folders that it made and that are empty go again.
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  std::vector<std::filesystem::path> made_;  // the innermost first
  int descriptor_ = -1;
};

}  // namespace collage
