#pragma once

#include <filesystem>

namespace collage {

/// Files that appear in a folder together, once all of them are written: a full disk in the middle
/// leaves what was there before as it was. They are written to a hidden folder in it and moved into
/// place by commit(). At most one at a time in a folder; a FolderLock sees to that.
class Staging {
 public:
  /// Removes what a killed process left of its own. Throws Error where nothing can be written.
  explicit Staging(const std::filesystem::path& folder);
  /// Removes what has not been moved.
  ~Staging();
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;

  /// Where to write.
  [[nodiscard]] const std::filesystem::path& folder() const { return staged_; }
  /// Moves all that is there, replacing files of the same names. Throws Error where one of them is
  /// a folder or device, before anything is moved.
  void commit();

 private:
  std::filesystem::path folder_;
  std::filesystem::path staged_;
};

}  // namespace collage
