#include "base/staging.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/error.h"
#include "base/file.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

class StagingTest : public testing::Test {
 protected:
  StagingTest() { write_file(folder_ / "a", "old"); }
  ~StagingTest() override { fs::remove_all(folder_); }

  fs::path folder_ = fs::temp_directory_path() / ("collage-staging-" + std::to_string(::getpid()));
};

TEST_F(StagingTest, NothingBeforeTheEndAllAtTheEnd) {
  {
    Staging staging(folder_);
    write_file(staging.folder() / "a", "new");
    write_file(staging.folder() / "deep" / "b", "new");
    EXPECT_EQ(read_file(folder_ / "a"), "old");
    EXPECT_FALSE(fs::exists(folder_ / "deep"));
    staging.commit();
  }
  EXPECT_EQ(read_file(folder_ / "a"), "new");
  EXPECT_EQ(read_file(folder_ / "deep" / "b"), "new");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 2);
}

TEST_F(StagingTest, WithoutCommitAllIsAsBefore) {
  {
    const Staging staging(folder_);
    write_file(staging.folder() / "a", "new");
  }
  EXPECT_EQ(read_file(folder_ / "a"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(StagingTest, ClearsAwayWhatAKilledOneLeft) {
  write_file(folder_ / ".collage-new" / "half", "…");
  Staging staging(folder_);
  staging.commit();
  EXPECT_FALSE(fs::exists(folder_ / "half"));
}

TEST_F(StagingTest, MovesNothingWhereOneOfThemCannotBe) {
  fs::create_directories(folder_ / "b");
  Staging staging(folder_);
  write_file(staging.folder() / "a", "new");
  write_file(staging.folder() / "b", "new");
  EXPECT_THROW(staging.commit(), Error);
  EXPECT_EQ(read_file(folder_ / "a"), "old");
}

}  // namespace
}  // namespace collage
