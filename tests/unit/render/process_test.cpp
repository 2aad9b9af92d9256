#include "render/process.h"

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "base/stopwatch.h"
#include "unit/render/support.h"

namespace collage {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using testing::error_of;
using ::testing::HasSubstr;
using testing::RecordingStatus;
using testing::TestFolder;

Command shell(const std::string& script) {
  return {.program = "/bin/sh", .arguments = {"-c", script}};
}

TEST(Process, hands_out_output_and_exit_code) {
  SystemRunner runner;
  const CommandResult result =
      run_command(runner, shell("echo out; echo err >&2; printf 'a\\rb'; exit 7"), Status());
  EXPECT_EQ(result.exit_code, 7);
  EXPECT_THAT(result.lines, ElementsAre("out", "err", "a", "b"));
}

TEST(Process, arguments_arrive_as_they_are) {
  SystemRunner runner;
  const Command command{.program = "printf", .arguments = {"%s", "a b; $(c) 'd' \"e\" *"}};
  EXPECT_THAT(run_command(runner, command, Status()).lines, ElementsAre("a b; $(c) 'd' \"e\" *"));
}

TEST(Process, has_an_empty_stdin_its_folder_and_its_environment) {
  const TestFolder folder;
  SystemRunner runner;
  Command command = shell("cat; pwd; echo \"$COLLAGE_A-${COLLAGE_B-unset}\"");
  command.folder = folder.path();
  ::setenv("COLLAGE_B", "ours", 1);
  command.environment = {{"COLLAGE_A", "given"}, {"COLLAGE_B", std::nullopt}};
  EXPECT_THAT(run_command(runner, command, Status()).lines,
              ElementsAre(folder.path().string(), "given-unset"));
}

TEST(Process, runs_several_at_once) {
  SystemRunner runner;
  const Stopwatch watch;
  for (int i = 0; i < 4; ++i) {
    runner.start(shell("sleep 0.3"), [](std::string_view) {});
  }
  int finished = 0;
  while (finished < 4) {
    finished += runner.wait(std::chrono::milliseconds(100)) ? 1 : 0;
  }
  EXPECT_LT(watch.seconds(), 1.1);
  EXPECT_FALSE(runner.wait(std::chrono::milliseconds(1000)));
  EXPECT_LT(watch.seconds(), 1.2) << "wait() with nothing running returns at once";
}

TEST(Process, long_output_is_complete) {
  SystemRunner runner;
  EXPECT_EQ(run_command(runner, shell("seq 1 50000"), Status()).lines.size(), 50000U);
}

TEST(Process, a_signal_becomes_128_and_its_number) {
  SystemRunner runner;
  EXPECT_EQ(run_command(runner, shell("kill -9 $$"), Status()).exit_code, 128 + SIGKILL);
}

TEST(Process, a_program_that_left_something_running_has_ended_with_it) {
  SystemRunner runner;
  const Stopwatch watch;
  EXPECT_EQ(run_command(runner, shell("sleep 20 & exit 3"), Status()).exit_code, 3);
  EXPECT_LT(watch.seconds(), 2.0);
}

TEST(Process, takes_no_more_than_it_may) {
  SystemRunner runner;
  Command command = shell("ulimit -v; ulimit -t; ulimit -c");
  command.memory_bytes = std::uint64_t{3} << 30;
  command.cpu_seconds = 7;
  EXPECT_THAT(run_command(runner, command, Status()).lines, ElementsAre("3145728", "7", "0"));
}

TEST(Process, says_what_cannot_be_started) {
  SystemRunner runner;
  const auto start = [&](const Command& command) {
    return error_of([&] { runner.start(command, [](std::string_view) {}); });
  };
  EXPECT_EQ(start({.program = "no-such-program", .arguments = {}}),
            "no-such-program cannot be started: No such file or directory; check that it is "
            "installed and may be run");
  Command command = shell("true");
  command.folder = "/no/such/folder";
  EXPECT_EQ(start(command), "/no/such/folder: is no folder any more; run the same command again");
  const TestFolder folder;
  write_file(folder / "broken", "#!/no/such/interpreter\n");
  fs::permissions(folder / "broken", fs::perms::owner_all);
  command.program = folder / "broken";
  command.folder.clear();
  EXPECT_THAT(start(command), HasSubstr("broken cannot be started"));
}

TEST(Process, finds_programs_on_path_only_where_they_can_run) {
  const TestFolder folder;
  const SystemRunner runner;
  write_file(folder / "plain", "text");
  EXPECT_TRUE(runner.find("sh"));
  EXPECT_FALSE(runner.find("no-such-program"));
  EXPECT_FALSE(runner.find((folder / "plain").string()));
}

TEST(Process, ctrl_c_ends_the_program_and_throws) {
  SystemRunner runner;
  RecordingStatus status;
  status.stops_after = 3;
  const Stopwatch watch;
  EXPECT_THROW(run_command(runner, shell("sleep 20"), status), Interrupted);
  EXPECT_LT(watch.seconds(), 1.5);
}

TEST(Process, one_that_ignores_sigterm_is_killed) {
  SystemRunner runner;
  bool is_ready = false;
  runner.start(shell("trap '' TERM; echo ready; while :; do sleep 0.1; done"),
               [&](std::string_view) { is_ready = true; });
  while (!is_ready) {
    runner.wait(std::chrono::milliseconds(10));
  }
  const Stopwatch watch;
  runner.stop_all();
  EXPECT_GE(watch.seconds(), 1.9);
  EXPECT_LT(watch.seconds(), 3.0);
  EXPECT_FALSE(runner.wait(std::chrono::milliseconds(10)));
}

}  // namespace
}  // namespace collage
