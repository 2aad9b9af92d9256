#include "render/process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.h"
#include "base/stopwatch.h"
#include "render/line_splitter.h"
#include "render/spawn.h"

namespace collage {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

/// How often we look for programs that ended without closing their output, and for Ctrl-C.
constexpr milliseconds look_every{50};
constexpr double patience_seconds = 2.0;

int exit_code_of(int wait_status) {
  return WIFSIGNALED(wait_status) ? 128 + WTERMSIG(wait_status) : WEXITSTATUS(wait_status);
}

}  // namespace

struct SystemRunner::Child {
  Id id;
  pid_t pid;
  Descriptor output;
  LineSplitter lines;

  /// Reads what is there, without waiting.
  void read_output() {
    std::array<char, 4096> bytes;
    while (output.get() >= 0) {
      const ssize_t got = ::read(output.get(), bytes.data(), bytes.size());
      if (got > 0) {
        lines.append({bytes.data(), static_cast<std::size_t>(got)});
      } else if (got == 0) {
        output.close();
      } else if (errno != EINTR) {
        return;
      }
    }
  }

  [[nodiscard]] bool has_ended() const {
    siginfo_t info{};
    return ::waitid(P_PID, static_cast<id_t>(pid), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           info.si_pid == pid;
  }

  /// Ends what is left of the group, and takes the leader's exit code.
  int bury() const {
    ::kill(-pid, SIGKILL);
    int wait_status = 0;
    while (::waitpid(pid, &wait_status, 0) < 0 && errno == EINTR) {
    }
    return exit_code_of(wait_status);
  }
};

SystemRunner::SystemRunner() = default;
SystemRunner::~SystemRunner() { SystemRunner::stop_all(); }

std::optional<fs::path> SystemRunner::find(const std::string& name) const {
  const auto is_program = [](const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored) && ::access(path.c_str(), X_OK) == 0;
  };
  if (name.find('/') != std::string::npos) {
    return is_program(name) ? std::optional(fs::absolute(name)) : std::nullopt;
  }
  const char* path = std::getenv("PATH");
  std::string_view rest = path == nullptr ? "/usr/bin:/bin" : path;
  while (!rest.empty()) {
    const std::string_view folder = rest.substr(0, rest.find(':'));
    rest.remove_prefix(std::min(rest.size(), folder.size() + 1));
    const fs::path candidate = fs::path(folder) / name;
    if (!folder.empty() && is_program(candidate)) {
      return fs::absolute(candidate);
    }
  }
  return std::nullopt;
}

CommandRunner::Id SystemRunner::start(const Command& command, LineSink on_line) {
  const std::optional<fs::path> program = find(command.program.string());
  if (!program) {
    throw_not_started(command.program, ENOENT);
  }
  Pipe pipe = make_pipe(*program);
  ::fcntl(pipe.read_end.get(), F_SETFL, O_NONBLOCK);
  const pid_t pid = spawn(command, *program, pipe.write_end);
  children_.push_back(std::make_unique<Child>(
      Child{next_id_, pid, std::move(pipe.read_end), LineSplitter(std::move(on_line))}));
  return next_id_++;
}

std::optional<CommandRunner::Finished> SystemRunner::reap() {
  for (auto child = children_.begin(); child != children_.end(); ++child) {
    if ((*child)->has_ended()) {
      const std::unique_ptr<Child> ended = std::move(*child);
      children_.erase(child);
      const int exit_code = ended->bury();
      ended->read_output();
      ended->lines.finish();
      return Finished{ended->id, exit_code};
    }
  }
  return std::nullopt;
}

std::optional<CommandRunner::Finished> SystemRunner::wait(milliseconds timeout) {
  const Stopwatch watch;
  while (!children_.empty()) {
    std::vector<pollfd> polled;
    milliseconds slice = std::min(timeout, look_every);
    for (const auto& child : children_) {
      polled.push_back({child->output.get(), POLLIN, 0});
      if (child->output.get() < 0) {
        slice = std::min(slice, milliseconds{2});  // its end is near
      }
    }
    ::poll(polled.data(), polled.size(), static_cast<int>(slice.count()));
    for (const auto& child : children_) {
      child->read_output();
    }
    const std::optional<Finished> finished = reap();
    if (finished || watch.seconds() * 1000 >= static_cast<double>(timeout.count())) {
      return finished;
    }
  }
  return std::nullopt;
}

void SystemRunner::stop_all() noexcept {
  for (const auto& child : children_) {
    child->output.close();  // a program blocked on writing goes on, and hears the signal
    ::kill(-child->pid, SIGTERM);
  }
  const Stopwatch watch;
  const auto runs = [](const auto& child) { return !child->has_ended(); };
  while (std::ranges::any_of(children_, runs) && watch.seconds() < patience_seconds) {
    std::this_thread::sleep_for(milliseconds{5});
  }
  for (const auto& child : children_) {
    child->bury();
  }
  children_.clear();
}

std::optional<CommandRunner::Finished> wait_or_stop(CommandRunner& runner, const Status& status) {
  if (status.stop_requested()) {
    runner.stop_all();
    throw Interrupted();
  }
  return runner.wait(look_every);
}

CommandResult run_command(CommandRunner& runner, const Command& command, const Status& status) {
  CommandResult result{};
  runner.start(command, [&](std::string_view line) { result.lines.emplace_back(line); });
  for (;;) {
    if (const auto finished = wait_or_stop(runner, status)) {
      result.exit_code = finished->exit_code;
      return result;
    }
  }
}

}  // namespace collage
