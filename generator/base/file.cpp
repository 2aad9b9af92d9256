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

namespace collage {
namespace {

namespace fs = std::filesystem;

std::string reason() { return std::generic_category().message(errno); }

constexpr std::size_t buffer_bytes = std::size_t{1} << 20;

/// A name beside `path` that no other thread or process uses.
fs::path temporary_beside(const fs::path& path) {
  static std::atomic<unsigned> counter{0};
  fs::path name = path;
  name += ".part-" + std::to_string(::getpid()) + "-" + std::to_string(counter++);
  return name;
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

FileWriter::FileWriter(fs::path path)
    : path_(std::move(path)), temporary_(temporary_beside(path_)) {
  std::error_code ignored;  // a folder that cannot be made is reported by open() below
  for (fs::path folder = path_.parent_path(); !folder.empty() && !fs::exists(folder, ignored);
       folder = folder.parent_path()) {
    folders_.push_back(folder);
  }
  fs::create_directories(path_.parent_path(), ignored);
  descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor_ < 0) {
    const int error = errno;
    remove_folders();
    errno = error;
    fail("created");
  }
  buffer_.reserve(buffer_bytes);
}

FileWriter::~FileWriter() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
    ::unlink(temporary_.c_str());
    remove_folders();
  }
}

/// Those that have been filled since stay.
void FileWriter::remove_folders() const {
  for (const fs::path& folder : folders_) {
    ::rmdir(folder.c_str());
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

void move_into_place(const fs::path& from, const fs::path& to) {
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
