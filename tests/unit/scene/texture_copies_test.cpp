#include "scene/texture_copies.h"

#include <gmock/gmock.h>

#include "unit/scene/support.h"

namespace collage {
namespace {

using namespace std::string_view_literals;
using testing::RecordingStatus;
using testing::TemporaryFolder;

TEST(TextureCopies, KnowsFormatsByTheirFirstBytes) {
  EXPECT_EQ(picture_format("\x89PNG\r\n\x1a\n..."sv, "a.jpg"), "png");
  EXPECT_EQ(picture_format("\xff\xd8\xff\xe0"sv, "a.png"), "jpeg");
  EXPECT_EQ(picture_format("GIF89a"sv, "a"), "gif");
  EXPECT_EQ(picture_format("MM\0*"sv, "a"), "tiff");
  EXPECT_EQ(picture_format("P5\n"sv, "a"), "pgm");
  EXPECT_EQ(picture_format("\0\0\2"sv, "a.tga"), "tga");
  EXPECT_EQ(picture_format("#!/bin/sh"sv, "a.png"), "");
  EXPECT_EQ(picture_format(""sv, "a.png"), "");
}

TEST(TextureCopies, CopiesEachPictureOnce) {
  const TemporaryFolder folder;
  RecordingStatus status;
  TextureCopies copies(folder.path() / "out", status);
  const auto first = copies.add(folder.write("a/x y.png", "\x89PNG\r\n\x1a\n one"));
  const auto second = copies.add(folder.write("b.jpeg", "\xff\xd8\xff two"));
  const auto again = copies.add(folder.write("c.png", "\x89PNG\r\n\x1a\n one"));
  ASSERT_TRUE(first && second && again);
  EXPECT_EQ(first->name, "texture-0.png");
  EXPECT_EQ(second->name, "texture-1.jpg");
  EXPECT_EQ(second->format, "jpeg");
  EXPECT_EQ(again->name, "texture-0.png");
  EXPECT_EQ(read_file(folder.path() / "out/texture-1.jpg"), "\xff\xd8\xff two");
}

TEST(TextureCopies, NotesWhatCannotBeUsed) {
  const TemporaryFolder folder;
  RecordingStatus status;
  TextureCopies copies(folder.path(), status);
  EXPECT_FALSE(copies.add(folder.path() / "none.png"));
  EXPECT_FALSE(copies.add(folder.write("notes.txt", "hello")));
  ASSERT_EQ(status.notes.size(), 2U);
  EXPECT_THAT(status.notes[0], ::testing::EndsWith("; the material's colour is used"));
  EXPECT_THAT(status.notes[1], ::testing::HasSubstr("notes.txt is not a picture"));
}

TEST(ClaimedPixels, AreReadFromTheHead) {
  using namespace std::string_view_literals;
  EXPECT_EQ(claimed_pixels("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\1\x86\xa0\0\1\x86\xa0"sv, "png"),
            10'000'000'000U);
  EXPECT_EQ(claimed_pixels("GIF89a\x20\0\x10\1"sv, "gif"), 32U * 272U);
  EXPECT_EQ(claimed_pixels("BM0123456789abcdef\x40\0\0\0\xff\xff\xff\xff"sv, "bmp"), 64U);
  EXPECT_EQ(claimed_pixels("0123456789ab\xff\xff\2\0"sv, "tga"), 65535U * 2U);
  EXPECT_EQ(claimed_pixels("\xff\xd8\xff\xe0\0\4__\xff\xc0\0\x11\x08\1\0\2\0\3"sv, "jpeg"),
            256U * 512U);
  EXPECT_EQ(claimed_pixels("\xff\xd8\xff\xe0\0\0"sv, "jpeg"), 0U);
  EXPECT_EQ(claimed_pixels("P6\n# GIMP 3\n100000\t# wide\n 90000\n255\n"sv, "ppm"), 9'000'000'000U);
  EXPECT_EQ(claimed_pixels("P5 # and no more"sv, "pgm"), 0U);
}

}  // namespace
}  // namespace collage
