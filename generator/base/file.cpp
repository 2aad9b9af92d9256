#include "base/file.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <openssl/evp.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"
#include "base/in_use.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

std::string reason() { return std::generic_category().message(errno); }

constexpr std::size_t buffer_bytes = std::size_t{1} << 20;

/// Temporary files are hidden, and their names too odd to be anybody else's.
constexpr std::string_view temporary_prefix = ".collage-part-";

/// A name in the folder that no other thread of this process takes.
fs::path temporary_in(const fs::path& folder) {
  static std::atomic<unsigned> counter{0};
  return folder / (std::string(temporary_prefix) + std::to_string(::getpid()) + "-" +
                   std::to_string(counter++));
}

void remove_abandoned(const fs::path& folder) {
  static VisitedFolders visited;
  if (!visited.add(folder)) {
    return;
  }
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    if (entry.path().filename().string().starts_with(temporary_prefix)) {
      if (const Abandoned abandoned(entry.path()); abandoned) {
        ::unlink(entry.path().c_str());
      }
    }
  }
}

}  // namespace

std::string read_file(const fs::path& path, std::uintmax_t limit_bytes) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) {
    throw Error({path}, errno == ENOENT ? "no such file" : "cannot be read: " + reason(),
                errno == ENOENT ? "check the path" : "check its permissions");
  }
  struct Closer {
    int descriptor;
    ~Closer() { ::close(descriptor); }
  } closer{descriptor};
  struct stat info {};
  if (::fstat(descriptor, &info) != 0 || !S_ISREG(info.st_mode)) {
    throw Error({path}, "is not a regular file", "name a file, not a folder or device");
  }
  if (static_cast<std::uintmax_t>(info.st_size) > limit_bytes) {
    throw Error({path}, "is larger than the limit of " + std::to_string(limit_bytes >> 20) + " MiB",
                "use a smaller file");
  }
  std::string content(static_cast<std::size_t>(info.st_size), '\0');
  std::size_t done = 0;
  while (done < content.size()) {
    const ssize_t got = ::read(descriptor, content.data() + done, content.size() - done);
    if (got < 0 && errno == EINTR) {
      continue;
    }
    if (got < 0) {
      throw Error({path}, "cannot be read: " + reason(), "check the disk");
    }
    if (got == 0) {
      break;
    }
    done += static_cast<std::size_t>(got);
  }
  content.resize(done);
  return content;
}

void write_file(const fs::path& path, std::string_view content) {
  FileWriter writer(path);
  writer.append(content);
  writer.commit();
}

FileWriter::FileWriter(fs::path path) : path_(std::move(path)) {
  require_replaceable(path_);
  const fs::path parent = path_.has_parent_path() ? path_.parent_path() : fs::path(".");
  folders_ = make_folders(parent);
  remove_abandoned(parent);
  while (!open_in(parent)) {
  }
  buffer_.reserve(buffer_bytes);
}

/// False where the name was taken, by a file that was left over or by those who clear such away.
bool FileWriter::open_in(const fs::path& folder) {
  temporary_ = temporary_in(folder);
  descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor_ < 0 && errno != EEXIST) {
    const int error = errno;
    remove_empty_folders(folders_);
    errno = error;
    fail("created");
  }
  if (descriptor_ >= 0 && !hold(descriptor_)) {
    ::close(std::exchange(descriptor_, -1));
  }
  return descriptor_ >= 0;
}

FileWriter::~FileWriter() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
    ::unlink(temporary_.c_str());
    remove_empty_folders(folders_);
  }
}

void FileWriter::fail(const char* action) const {
  throw Error({path_}, std::string("cannot be ") + action + ": " + reason(),
              "check the folder's permissions and free space, or choose another with -o");
}

void FileWriter::append(std::string_view text) {
  buffer_.append(text);
  if (buffer_.size() >= buffer_bytes) {
    flush();
  }
}

void FileWriter::flush() {
  std::size_t done = 0;
  while (done < buffer_.size()) {
    const ssize_t put = ::write(descriptor_, buffer_.data() + done, buffer_.size() - done);
    if (put < 0 && errno != EINTR) {
      fail("written");
    }
    done += put > 0 ? static_cast<std::size_t>(put) : 0;
  }
  buffer_.clear();
}

void FileWriter::commit() {
  flush();
  if (::fsync(descriptor_) != 0) {
    fail("written");
  }
  const int descriptor = std::exchange(descriptor_, -1);
  if (::close(descriptor) != 0 || ::rename(temporary_.c_str(), path_.c_str()) != 0) {
    const int error = errno;
    ::unlink(temporary_.c_str());
    errno = error;
    fail("written");
  }
}

std::vector<fs::path> make_folders(const fs::path& folder) {
  std::vector<fs::path> made;
  std::error_code ignored;  // a folder that cannot be made is reported by whoever uses it
  for (fs::path f = folder; !f.empty() && !fs::exists(f, ignored); f = f.parent_path()) {
    made.push_back(f);
  }
  fs::create_directories(folder, ignored);
  return made;
}

void remove_empty_folders(const std::vector<fs::path>& folders) {
  for (const fs::path& folder : folders) {
    ::rmdir(folder.c_str());
  }
}

void require_replaceable(const fs::path& path) {
  std::error_code ignored;  // what cannot be looked at is reported by whoever writes
  const fs::file_status status = fs::status(path, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    throw Error({path}, "is there already and is not a regular file", "choose another name");
  }
}

void move_into_place(const fs::path& from, const fs::path& to) {
  require_replaceable(to);
  if (::rename(from.c_str(), to.c_str()) != 0) {
    throw Error({to}, "cannot be written: " + reason(),
                "check the folder's permissions and free space");
  }
}

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
  unsigned length = 0;
  EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr);
  std::string text;
  for (unsigned i = 0; i < length; ++i) {
    constexpr std::string_view hex = "0123456789abcdef";
    text += hex[digest[i] >> 4];
    text += hex[digest[i] & 15];
  }
  return text;
}

}  // namespace collage
