#include "render/spawn.h"

#include <array>
#include <thread>

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/stopwatch.h"
#include "unit/render/support.h"

namespace collage {
namespace {

Command sleeping() { return {.program = "/bin/sleep", .arguments = {"20"}}; }

TEST(Spawn, leads_a_process_group_of_its_own) {
  const Pipe pipe = make_pipe("sleep");
  const pid_t pid = spawn(sleeping(), "/bin/sleep", pipe.write_end);
  EXPECT_EQ(::getpgid(pid), pid);
  ::kill(pid, SIGKILL);
  ::waitpid(pid, nullptr, 0);
}

TEST(Spawn, dies_with_the_process_that_started_it) {
  const Pipe pipe = make_pipe("sleep");
  const pid_t parent = ::fork();
  if (parent == 0) {
    spawn(sleeping(), "/bin/sleep", pipe.write_end);
    ::_exit(0);
  }
  ::waitpid(parent, nullptr, 0);
  const Stopwatch watch;
  ::close(::dup2(::open("/dev/null", O_WRONLY | O_CLOEXEC), pipe.write_end.get()));
  char byte = 0;
  EXPECT_EQ(::read(pipe.read_end.get(), &byte, 1), 0) << "the last writer is gone";
  EXPECT_LT(watch.seconds(), 5.0);
}

TEST(Spawn, a_descriptor_is_closed_once) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  {
    Descriptor first(ends[0]);
    const Descriptor second = std::move(first);
    EXPECT_EQ(first.get(), -1);
    EXPECT_EQ(second.get(), ends[0]);
  }
  EXPECT_EQ(::fcntl(ends[0], F_GETFD), -1);
  ::close(ends[1]);
}

}  // namespace
}  // namespace collage
