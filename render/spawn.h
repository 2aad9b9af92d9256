#pragma once

#include <filesystem>
#include <utility>

#include <sys/types.h>

#include "render/process.h"

namespace collage {

/// A file descriptor that is closed with its owner; -1: none.
class Descriptor {
 public:
  explicit Descriptor(int value = -1) : value_(value) {}
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : value_(std::exchange(other.value_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(value_, other.value_);
    return *this;
  }
  void close();
  [[nodiscard]] int get() const { return value_; }

 private:
  int value_;
};

struct Pipe {
  Descriptor read_end;
  Descriptor write_end;
};

/// Both ends are closed by exec. `program` is for the message of the Error.
Pipe make_pipe(const std::filesystem::path& program);

/// Starts `program` with an empty stdin and its output going to `output`, as leader of a process
/// group of its own, to die with the calling thread; returns once it runs. Throws Error (outside
/// program) where it cannot be started.
pid_t spawn(const Command& command, const std::filesystem::path& program, const Descriptor& output);

[[noreturn]] void throw_not_started(const std::filesystem::path& program, int error);

}  // namespace collage
