#include "base/file.h"

#include <fstream>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

/// A fresh folder, which stays where a test failed.
class FileTest : public testing::Test {
 protected:
  FileTest() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ =
        fs::temp_directory_path() / ("collage-" + std::to_string(::getpid()) + "-" + info->name());
    fs::create_directories(folder_);
  }
  ~FileTest() override {
    if (!HasFailure()) {
      fs::remove_all(folder_);
    }
  }
  std::size_t file_count() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  fs::path folder_;
};

TEST_F(FileTest, ReadsBackWhatItWrote) {
  const std::string content("a\0b\r\n\xff", 6);
  write_file(folder_ / "new" / "deep" / "file", content);
  EXPECT_EQ(read_file(folder_ / "new" / "deep" / "file"), content);
  write_file(folder_ / "new" / "deep" / "file", "");
  EXPECT_EQ(read_file(folder_ / "new" / "deep" / "file"), "");
}

TEST_F(FileTest, LeavesNoFolderBehindWhereNothingIsWritten) {
  { const FileWriter writer(folder_ / "new" / "deep" / "file"); }
  EXPECT_EQ(file_count(), 0U);
  fs::create_directories(folder_ / "there");
  { const FileWriter writer(folder_ / "there" / "deep" / "file"); }
  EXPECT_TRUE(fs::is_directory(folder_ / "there"));
  EXPECT_FALSE(fs::exists(folder_ / "there" / "deep"));
  {
    const FileWriter writer(folder_ / "new" / "deep" / "file");
    write_file(folder_ / "new" / "other", "of use");
  }
  EXPECT_TRUE(fs::exists(folder_ / "new" / "other"));
  EXPECT_FALSE(fs::exists(folder_ / "new" / "deep"));
}

TEST_F(FileTest, AppearsWholeOrNotAtAll) {
  write_file(folder_ / "file", "old");
  {
    FileWriter writer(folder_ / "file");
    writer.append(std::string(3 << 20, 'x'));
    EXPECT_EQ(read_file(folder_ / "file"), "old");
  }
  EXPECT_EQ(read_file(folder_ / "file"), "old");
  EXPECT_EQ(file_count(), 1U);
  FileWriter writer(folder_ / "file");
  writer.append("new");
  writer.commit();
  EXPECT_EQ(read_file(folder_ / "file"), "new");
  EXPECT_EQ(file_count(), 1U);
}

TEST_F(FileTest, ReadsOnlyRegularFilesOfTheSizeAllowed) {
  EXPECT_THROW(read_file(folder_), Error);
  EXPECT_THROW(read_file(folder_ / "missing"), Error);
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  EXPECT_THROW(read_file(folder_ / "pipe"), Error);
  write_file(folder_ / "file", "12345");
  EXPECT_EQ(read_file(folder_ / "file", 5), "12345");
  EXPECT_THROW(read_file(folder_ / "file", 4), Error);
}

TEST_F(FileTest, ClearsAwayWhatAKilledProcessLeftAndNothingElse) {
  write_file(folder_ / "a" / ".collage-part-1-0", "left over");
  write_file(folder_ / "a" / "part-1-0", "somebody's");
  fs::rename(folder_ / "a", folder_ / "c");
  FileWriter unfinished(folder_ / "c" / "unfinished");  // looks at c
  EXPECT_FALSE(fs::exists(folder_ / "c" / ".collage-part-1-0"));
  EXPECT_TRUE(fs::exists(folder_ / "c" / "part-1-0"));
  fs::rename(folder_ / "c", folder_ / "d");
  write_file(folder_ / "d" / "other", "");  // looks at d, where `unfinished` is held by us
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "d"), fs::directory_iterator()), 3);
  fs::rename(folder_ / "d", folder_ / "c");
  unfinished.append("whole");
  unfinished.commit();
  EXPECT_EQ(read_file(folder_ / "c" / "unfinished"), "whole");
}

TEST_F(FileTest, PutsNothingInThePlaceOfADevice) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  fs::create_symlink("/dev/null", folder_ / "link");
  for (const char* name : {"pipe", "link", "."}) {
    EXPECT_THROW(write_file(folder_ / name, "x"), Error) << name;
  }
  EXPECT_TRUE(fs::is_fifo(folder_ / "pipe"));
  EXPECT_TRUE(fs::is_character_file(folder_ / "link"));
  EXPECT_EQ(file_count(), 2U);
}

TEST_F(FileTest, ALinkGivesWayToTheFileAndItsTargetStays) {
  write_file(folder_ / "target", "old");
  fs::create_symlink("target", folder_ / "link");
  write_file(folder_ / "link", "new");
  EXPECT_EQ(read_file(folder_ / "target"), "old");
  EXPECT_EQ(read_file(folder_ / "link"), "new");
}

TEST_F(FileTest, SaysWhichFileCannotBeWritten) {
  write_file(folder_ / "file", "");
  try {
    write_file(folder_ / "file" / "below", "x");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).find((folder_ / "file" / "below").string()), 0U);
  }
}

TEST_F(FileTest, MoveReplaces) {
  write_file(folder_ / "from", "new");
  write_file(folder_ / "to", "old");
  move_into_place(folder_ / "from", folder_ / "to");
  EXPECT_EQ(read_file(folder_ / "to"), "new");
  EXPECT_EQ(file_count(), 1U);
  EXPECT_THROW(move_into_place(folder_ / "from", folder_ / "to"), Error);
}

TEST(Sha256, KnownAnswers) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace
}  // namespace collage
