#include "render/spawn.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> environment_of(const Command& command) {
  std::vector<std::string> variables;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view text = *variable;
    const auto is_changed = [&](const auto& change) {
      return text.substr(0, text.find('=')) == change.first;
    };
    if (std::ranges::none_of(command.environment, is_changed)) {
      variables.emplace_back(text);
    }
  }
  for (const auto& [name, value] : command.environment) {
    if (value) {
      variables.push_back(name + "=" + *value);
    }
  }
  return variables;
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  pointers.reserve(texts.size() + 1);
  for (std::string& text : texts) {
    pointers.push_back(text.data());
  }
  pointers.push_back(nullptr);
  return pointers;
}

/// What the new process needs, laid out before fork(): after it nothing may allocate.
struct Launch {
  const char* program;
  char* const* arguments;
  char* const* environment;
  const char* folder;  // nullptr: ours
  rlim_t memory;
  rlim_t seconds;
  pid_t parent;
  int output;
  int report;  // where the reason of a failure goes; closed by a successful exec
};

/// Lowers a limit; one that is lower already stays.
void limit(decltype(RLIMIT_AS) resource, rlim_t value) {
  rlimit now{};
  if (::getrlimit(resource, &now) == 0) {
    now.rlim_cur = std::min(now.rlim_cur, value);
    ::setrlimit(resource, &now);
  }
}

/// In the new process, between fork() and exec: system calls only.
[[noreturn]] void become(const Launch& launch) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  for (const int number : {SIGINT, SIGTERM, SIGPIPE, SIGHUP}) {
    ::signal(number, SIG_DFL);
  }
  limit(RLIMIT_AS, launch.memory);
  limit(RLIMIT_CPU, launch.seconds);
  limit(RLIMIT_CORE, 0);
  const int empty = ::open("/dev/null", O_RDONLY);
  const bool ready = ::getppid() == launch.parent && ::dup2(empty, STDIN_FILENO) >= 0 &&
                     ::dup2(launch.output, STDOUT_FILENO) >= 0 &&
                     ::dup2(launch.output, STDERR_FILENO) >= 0 &&
                     (launch.folder == nullptr || ::chdir(launch.folder) == 0);
  if (ready) {
    ::execve(launch.program, launch.arguments, launch.environment);
  }
  const int error = errno;
  [[maybe_unused]] const ssize_t written = ::write(launch.report, &error, sizeof error);
  ::_exit(127);
}

}  // namespace

void Descriptor::close() {
  if (value_ >= 0) {
    ::close(std::exchange(value_, -1));
  }
}

void throw_not_started(const fs::path& program, int error) {
  throw Error::outside_program(
      program.string() + " cannot be started: " + std::generic_category().message(error),
      "check that it is installed and may be run");
}

Pipe make_pipe(const fs::path& program) {
  std::array<int, 2> ends;
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw_not_started(program, errno);
  }
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

pid_t spawn(const Command& command, const fs::path& program, const Descriptor& output) {
  Pipe report = make_pipe(program);
  std::vector<std::string> arguments{program.string()};
  arguments.insert(arguments.end(), command.arguments.begin(), command.arguments.end());
  std::vector<std::string> environment = environment_of(command);
  const std::vector<char*> argument_pointers = pointers_to(arguments);
  const std::vector<char*> environment_pointers = pointers_to(environment);
  const Launch launch{.program = program.c_str(),
                      .arguments = argument_pointers.data(),
                      .environment = environment_pointers.data(),
                      .folder = command.folder.empty() ? nullptr : command.folder.c_str(),
                      .memory = command.memory_bytes.value_or(RLIM_INFINITY),
                      .seconds = command.cpu_seconds.value_or(RLIM_INFINITY),
                      .parent = ::getpid(),
                      .output = output.get(),
                      .report = report.write_end.get()};
  const pid_t pid = ::fork();
  if (pid == 0) {
    become(launch);
  }
  if (pid < 0) {
    throw_not_started(program, errno);
  }
  ::setpgid(pid, pid);
  report.write_end.close();
  int error = 0;
  if (::read(report.read_end.get(), &error, sizeof error) > 0) {
    ::waitpid(pid, nullptr, 0);
    std::error_code ignored;
    if (launch.folder != nullptr && !fs::is_directory(command.folder, ignored)) {
      throw Error({command.folder}, "is no folder any more", "run the same command again");
    }
    throw_not_started(program, error);
  }
  return pid;
}

}  // namespace collage
