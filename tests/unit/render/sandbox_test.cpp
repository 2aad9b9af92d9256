#include "render/sandbox.h"

#include <netinet/in.h>
#include <sys/socket.h>

#include "unit/render/support.h"

namespace collage {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using testing::TestFolder;

TEST(Sandbox, keeps_all_of_the_command) {
  const TestFolder folder;
  const Command plain{.program = "/opt/pov/povray",
                      .arguments = {"+Iscene.pov", "+W 10"},
                      .folder = folder.path(),
                      .environment = {{"POVINI", std::nullopt}},
                      .memory_bytes = 7,
                      .cpu_seconds = 8};
  const Command inside = sandboxed("/usr/bin/bwrap", plain);
  EXPECT_EQ(inside.program, "/usr/bin/bwrap");
  EXPECT_EQ(inside.folder, plain.folder);
  EXPECT_EQ(inside.environment, plain.environment);
  EXPECT_EQ(inside.memory_bytes, plain.memory_bytes);
  EXPECT_EQ(inside.cpu_seconds, plain.cpu_seconds);
  const std::vector<std::string>& arguments = inside.arguments;
  const auto own = std::ranges::find(arguments, "--");
  ASSERT_NE(own, arguments.end());
  EXPECT_EQ(std::vector(own + 1, arguments.end()),
            (std::vector<std::string>{"/opt/pov/povray", "+Iscene.pov", "+W 10"}));
}

class RealSandbox : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto bwrap = runner_.find("bwrap");
    if (!bwrap || run(*bwrap, "true").exit_code != 0) {
      GTEST_SKIP() << "bubblewrap is not installed, or does not work here";
    }
    bwrap_ = *bwrap;
  }
  CommandResult run(const fs::path& bwrap, const std::string& script) {
    return run_command(
        runner_,
        sandboxed(bwrap,
                  {.program = "/bin/sh", .arguments = {"-c", script}, .folder = inner_.path()}),
        Status());
  }

  SystemRunner runner_;
  fs::path bwrap_;
  TestFolder inner_;
  TestFolder outer_;
};

TEST_F(RealSandbox, writes_to_its_folder_and_nowhere_else) {
  write_file(outer_ / "secret", "secret");
  const std::string elsewhere = outer_.path().string();
  const CommandResult result =
      run(bwrap_, "pwd; echo ours >here; cat here; cat " + elsewhere + "/secret; echo x >" +
                      elsewhere + "/there; echo x >/usr/there; ls /home /root; exit 5");
  EXPECT_EQ(result.exit_code, 5);
  ASSERT_GE(result.lines.size(), 2U);
  EXPECT_EQ(result.lines[0], fs::canonical(inner_.path()).string());
  EXPECT_EQ(result.lines[1], "ours");
  for (const std::string& line : result.lines) {
    EXPECT_NE(line, "secret");
  }
  EXPECT_EQ(read_file(inner_ / "here"), "ours\n");
  EXPECT_THAT(outer_.files(), ElementsAre("secret"));
}

TEST_F(RealSandbox, has_no_network) {
  const int listener = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* const any = reinterpret_cast<sockaddr*>(&address);
  ASSERT_EQ(::bind(listener, any, size), 0);
  ASSERT_EQ(::listen(listener, 2), 0);
  ASSERT_EQ(::getsockname(listener, any, &size), 0);
  const std::string port = std::to_string(ntohs(address.sin_port));
  const Command connect{.program = "/bin/bash",
                        .arguments = {"-c", "exec 3<>/dev/tcp/127.0.0.1/" + port},
                        .folder = inner_.path()};
  EXPECT_EQ(run_command(runner_, connect, Status()).exit_code, 0);
  EXPECT_NE(run_command(runner_, sandboxed(bwrap_, connect), Status()).exit_code, 0);
  ::close(listener);
}

TEST_F(RealSandbox, a_killed_program_is_seen_as_killed) {
  EXPECT_EQ(run(bwrap_, "kill -KILL $$").exit_code, 137);
}

}  // namespace
}  // namespace collage
