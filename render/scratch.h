#pragma once

#include <filesystem>
#include <string>

namespace collage {

/// A set of temporary files in one folder with a name of their own, which no other thread, process
/// or machine uses at the same time. They go with the object; those of a process that was killed
/// go when another first comes to the folder, or with remove_stale_scratch(). A lock on the file
/// <stem>.lock tells the two apart.
class Scratch {
 public:
  /// Makes the folder where it is missing. Throws Error where nothing can be written there.
  explicit Scratch(const std::filesystem::path& folder);
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  /// "<stem><extension>", the name within the folder: ASCII, without spaces.
  [[nodiscard]] std::string name(const std::string& extension) const { return stem_ + extension; }
  [[nodiscard]] std::filesystem::path path(const std::string& extension) const {
    return folder_ / name(extension);
  }

 private:
  [[nodiscard]] bool lock();

  std::filesystem::path folder_;
  std::string stem_;
  int descriptor_ = -1;
};

/// Removes the temporary files of processes that are no more. A folder that is missing is fine.
void remove_stale_scratch(const std::filesystem::path& folder);

}  // namespace collage
