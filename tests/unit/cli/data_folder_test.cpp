#include "cli/data_folder.h"

#include <cstdlib>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

class DataFolder : public testing::Test {
 protected:
  DataFolder() : root_(fs::path(testing::TempDir()) / "data_folder_test.XXXXXX") {
    std::string name = root_.string();
    root_ = ::mkdtemp(name.data());
  }
  ~DataFolder() override { fs::remove_all(root_); }

  fs::path with_templates(const std::string& folder) const {
    fs::create_directories(root_ / folder / "templates");
    return root_ / folder;
  }

  fs::path root_;
};

TEST_F(DataFolder, LiesBesideTheInstalledProgram) {
  const fs::path share = with_templates("usr/share/collage");
  EXPECT_EQ(data_folder({"", root_ / "usr/bin/collage", with_templates("source")}), share);
}

TEST_F(DataFolder, IsTheSourceInABuildTree) {
  const fs::path source = with_templates("source");
  EXPECT_EQ(data_folder({"", root_ / "source/build/release/generator/cli/collage", source}),
            source);
}

TEST_F(DataFolder, IsTheUsersWishBeforeAllElse) {
  const fs::path wish = with_templates("mine");
  with_templates("usr/share/collage");
  EXPECT_EQ(data_folder({wish, root_ / "usr/bin/collage", with_templates("source")}), wish);
}

TEST_F(DataFolder, RefusesAWishWithoutTemplates) {
  try {
    data_folder({"/no/such", root_ / "usr/bin/collage", with_templates("source")});
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "/no/such: has no folder 'templates'; set COLLAGE_DATA to the folder that holds "
                 "collage's templates and scenes");
  }
}

TEST_F(DataFolder, SaysThatItIsNotFound) {
  try {
    data_folder({"", root_ / "usr/bin/collage", root_ / "gone"});
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "collage's templates and scenes are not found; install it again, or set "
                 "COLLAGE_DATA to the folder that holds them");
  }
}

TEST_F(DataFolder, KnowsTheRunningProgram) {
  EXPECT_THAT(data_places().executable.filename().string(), testing::StartsWith("cli_test"));
}

}  // namespace
}  // namespace collage
