#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace collage {

/// The whole content of a regular file. Throws Error where it is missing, not a regular file (a
/// folder, a device, a pipe), not readable, or larger than `limit_bytes`.
std::string read_file(const std::filesystem::path& path,
                      std::uintmax_t limit_bytes = std::uintmax_t{4} << 30);

/// Writes a file whole or not at all: to a temporary name in the same folder, then renamed. Makes
/// missing folders. Temporary files that a process left there as it was killed are removed when
/// another first writes to the folder. Throws Error naming `path` where the disk is full, the
/// folder unwritable, or a folder or device in the way.
void write_file(const std::filesystem::path& path, std::string_view content);

/// A file written piece by piece, under the same promise: it appears under its name by commit(),
/// and an object that dies without leaves nothing behind, nor a folder that it made.
class FileWriter {
 public:
  explicit FileWriter(std::filesystem::path path);
  ~FileWriter();
  FileWriter(const FileWriter&) = delete;
  FileWriter& operator=(const FileWriter&) = delete;

  void append(std::string_view text);
  void commit();

 private:
  bool open_in(const std::filesystem::path& folder);
  void flush();
  [[noreturn]] void fail(const char* action) const;

  std::filesystem::path path_;
  std::filesystem::path temporary_;
  std::vector<std::filesystem::path> folders_;  // those that were missing, the innermost first
  std::string buffer_;
  int descriptor_ = -1;
};

/// Throws Error where a folder or a device, even behind a link, stands where a file is to go.
void require_replaceable(const std::filesystem::path& path);

/// Renames within one folder's file system, replacing `to`; the rename is durable.
void move_into_place(const std::filesystem::path& from, const std::filesystem::path& to);

/// Makes a folder with those above it that are missing, as far as that can be done; returns the
/// ones that were missing, the innermost first.
std::vector<std::filesystem::path> make_folders(const std::filesystem::path& folder);

/// Removes those of make_folders() that nobody has put anything into.
void remove_empty_folders(const std::vector<std::filesystem::path>& folders);

/// SHA-256 as 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace collage
