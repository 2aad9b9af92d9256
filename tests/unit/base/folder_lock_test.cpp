#include "base/folder_lock.h"

#include <optional>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/error.h"
#include "base/file.h"

namespace collage {
namespace {

namespace fs = std::filesystem;
using Kind = FolderLock::Kind;

class FolderLockTest : public testing::Test {
 protected:
  ~FolderLockTest() override { fs::remove_all(folder_); }

  fs::path folder_ =
      fs::temp_directory_path() / ("collage-folder-lock-" + std::to_string(::getpid()));
};

TEST_F(FolderLockTest, OneAloneOrSeveralShared) {
  std::optional<FolderLock> first(std::in_place, folder_, Kind::alone);
  EXPECT_THROW(FolderLock(folder_, Kind::alone), Error);
  EXPECT_THROW(FolderLock(folder_, Kind::shared), Error);
  write_file(folder_ / "file", "");
  first.reset();
  const FolderLock second(folder_, Kind::shared);
  const FolderLock third(folder_, Kind::shared);
  EXPECT_THROW(FolderLock(folder_, Kind::alone), Error);
}

TEST_F(FolderLockTest, MakesTheFolderAndTakesItAwayUnlessItIsUsed) {
  { const FolderLock lock(folder_ / "deep" / "er", Kind::alone); }
  EXPECT_FALSE(fs::exists(folder_));
  {
    const FolderLock lock(folder_ / "deep", Kind::alone);
    write_file(folder_ / "deep" / "file", "");
  }
  EXPECT_TRUE(fs::exists(folder_ / "deep" / "file"));
}

TEST_F(FolderLockTest, WhereThereIsNoFolderThereIsNothingToLock) {
  const FolderLock lock(folder_, Kind::shared);
  EXPECT_FALSE(fs::exists(folder_));
}

}  // namespace
}  // namespace collage
