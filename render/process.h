#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/status.h"

namespace collage {

/// A program and what it is given. No shell sees it: every argument arrives as it is.
struct Command {
  /// A path, or a name that is looked up on PATH.
  std::filesystem::path program{};
  /// Without the program's name.
  std::vector<std::string> arguments{};
  /// Working folder; empty: ours.
  std::filesystem::path folder{};
  /// Changes to our environment; nullopt: the variable is not set.
  std::vector<std::pair<std::string, std::optional<std::string>>> environment{};
  /// At most so much address space and so much computing, over all its threads; none: as ours.
  std::optional<std::uint64_t> memory_bytes{};
  std::optional<std::uint64_t> cpu_seconds{};
};

/// Runs programs, several at once, from one thread. An interface, so that tests can do without.
class CommandRunner {
 public:
  using Id = int;
  /// Gets what a program writes to stdout and stderr, in pieces that end with \n or \r (taken off).
  using LineSink = std::function<void(std::string_view)>;
  struct Finished {
    Id id;
    /// 128 + signal where a signal ended the program.
    int exit_code;
  };

  virtual ~CommandRunner() = default;

  /// Where PATH has an executable file of this name; a name with a slash is taken as a path.
  [[nodiscard]] virtual std::optional<std::filesystem::path> find(
      const std::string& name) const = 0;

  /// Starts a program with an empty stdin. It dies with the calling thread, should that end first.
  /// Throws Error (outside program) where it cannot be started.
  virtual Id start(const Command& command, LineSink on_line) = 0;

  /// Hands out output until a program has finished or the time is up; nullopt: none has finished.
  /// Returns at once where nothing runs.
  virtual std::optional<Finished> wait(std::chrono::milliseconds timeout) = 0;

  /// Ends whatever runs: SIGTERM, and SIGKILL for those still there after two seconds.
  virtual void stop_all() noexcept = 0;
};

/// The real thing. Each program leads a process group of its own, so that a Ctrl-C in the terminal
/// reaches us alone; the destructor ends what still runs.
class SystemRunner : public CommandRunner {
 public:
  SystemRunner();
  ~SystemRunner() override;
  SystemRunner(const SystemRunner&) = delete;
  SystemRunner& operator=(const SystemRunner&) = delete;

  [[nodiscard]] std::optional<std::filesystem::path> find(const std::string& name) const override;
  Id start(const Command& command, LineSink on_line) override;
  std::optional<Finished> wait(std::chrono::milliseconds timeout) override;
  void stop_all() noexcept override;

 private:
  struct Child;
  std::optional<Finished> reap();

  std::vector<std::unique_ptr<Child>> children_;
  Id next_id_ = 0;
};

struct CommandResult {
  int exit_code;
  std::vector<std::string> lines;
};

/// Runs one program to its end; nothing else may be running. Throws Interrupted, after ending the
/// program, once the user asks to stop.
CommandResult run_command(CommandRunner& runner, const Command& command, const Status& status);

/// A short wait() that hears Ctrl-C: throws Interrupted, after ending everything that runs, once
/// the user asks to stop.
std::optional<CommandRunner::Finished> wait_or_stop(CommandRunner& runner, const Status& status);

}  // namespace collage
