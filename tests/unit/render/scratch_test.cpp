#include "render/scratch.h"

#include <sys/wait.h>

#include "unit/render/support.h"

namespace collage {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::TestFolder;

TEST(Scratch, its_files_go_with_it) {
  const TestFolder folder;
  write_file(folder / "kept.png", "");
  {
    const Scratch one(folder.path());
    const Scratch other(folder.path());
    EXPECT_NE(one.name(".png"), other.name(".png"));
    write_file(one.path(".png"), "picture");
    write_file(one.path(".pov-state"), "state");
  }
  EXPECT_THAT(folder.files(), ElementsAre("kept.png"));
}

TEST(Scratch, files_of_a_killed_process_are_cleaned_up_and_those_of_a_live_one_are_not) {
  const TestFolder folder;
  const Scratch alive(folder.path());
  write_file(alive.path(".png"), "picture");
  const pid_t child = ::fork();
  if (child == 0) {
    const Scratch dead(folder.path());
    write_file(dead.path(".png"), "picture");
    ::_exit(0);  // runs no destructors, as after kill -9
  }
  ::waitpid(child, nullptr, 0);
  EXPECT_EQ(folder.files().size(), 4U);
  remove_stale_scratch(folder.path());
  EXPECT_THAT(folder.files(), ElementsAre(alive.name(".lock"), alive.name(".png")));
}

TEST(Scratch, a_missing_folder_is_made_by_one_and_ignored_by_the_other) {
  const TestFolder folder;
  remove_stale_scratch(folder / "missing");
  EXPECT_FALSE(fs::exists(folder / "missing"));
  const Scratch scratch(folder / "missing");
  EXPECT_TRUE(fs::exists(folder / "missing"));
}

TEST(Scratch, says_which_folder_cannot_be_written_to) {
  const TestFolder folder;
  write_file(folder / "file", "");
  EXPECT_THAT(testing::error_of([&] { const Scratch scratch(folder / "file"); }),
              ::testing::StartsWith((folder / "file").string() + ": cannot be written to: "));
}

}  // namespace
}  // namespace collage
