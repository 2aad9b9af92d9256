#include "render/picture_file.h"

#include <limits>

#include <sys/resource.h>

#include "unit/render/support.h"

namespace collage {
namespace {

namespace fs = std::filesystem;
using testing::cut_in_half;
using testing::error_of;
using ::testing::HasSubstr;
using testing::plain_picture;
using testing::TestFolder;

Picture gradient(PictureFormat format) {
  Picture picture = plain_picture(61, 37);
  picture.format = format;
  for (std::size_t i = 0; i < picture.values.size(); ++i) {
    picture.values[i] = static_cast<float>(i * 7919 % 256) / 255.0F;
    if (format == PictureFormat::exr) {
      picture.values[i] = static_cast<float>(i * 7919 % 256) * 0.125F;  // exact as a half float
    }
  }
  picture.key = "0123abcd";
  return picture;
}

class PictureFile : public ::testing::TestWithParam<PictureFormat> {
 protected:
  [[nodiscard]] fs::path path(const std::string& stem) const {
    return folder_ / (stem + extension(GetParam()));
  }
  TestFolder folder_;
};

TEST_P(PictureFile, pixels_and_key_come_back) {
  const Picture written = gradient(GetParam());
  write_picture(path("a"), written);
  const Picture read = read_picture(path("a"));
  EXPECT_EQ(read.width, written.width);
  EXPECT_EQ(read.height, written.height);
  EXPECT_EQ(read.channels, 3);
  EXPECT_EQ(read.format, GetParam());
  EXPECT_EQ(read.key, "0123abcd");
  EXPECT_THAT(read.values, ::testing::Pointwise(::testing::FloatEq(), written.values));
  EXPECT_EQ(folder_.files().size(), 1U);
}

TEST_P(PictureFile, equal_pictures_give_equal_bytes_without_a_date) {
  write_picture(path("a"), gradient(GetParam()));
  write_picture(path("b"), gradient(GetParam()));
  const std::string bytes = read_file(path("a"));
  EXPECT_EQ(bytes, read_file(path("b")));
  for (const char* word : {"tIME", "1970:", "202", "ImageHistory", "collage-render-test"}) {
    EXPECT_EQ(bytes.find(word), std::string::npos) << word;
  }
}

TEST_P(PictureFile, one_cut_short_is_an_error) {
  write_picture(path("a"), gradient(GetParam()));
  cut_in_half(path("a"));
  EXPECT_THAT(error_of([&] { read_picture(path("a")); }),
              HasSubstr(path("a").string() + ": is not"));
  fs::resize_file(path("a"), 0);
  EXPECT_THAT(error_of([&] { read_picture(path("a")); }), HasSubstr("is not a picture"));
}

TEST(PictureFileErrors, a_png_with_any_bit_turned_is_an_error_and_nothing_else_is_said) {
  const TestFolder folder;
  write_picture(folder / "a.png", gradient(PictureFormat::png));
  const std::string whole = read_file(folder / "a.png");
  ::testing::internal::CaptureStderr();
  for (std::size_t at = 0; at < whole.size(); at += 97) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << at % 8));
    write_file(folder / "b.png", damaged);
    EXPECT_THAT(error_of([&] { read_picture(folder / "b.png"); }), HasSubstr("b.png: is not"))
        << at;
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

/// The most memory that this process has had.
long peak_kilobytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

TEST(PictureFileErrors, an_attribute_of_an_exr_that_claims_gigabytes_does_not_get_them) {
  using namespace std::string_literals;
  const TestFolder folder;
  const std::string header = "\x76\x2f\x31\x01\x02\0\0\0"s;
  write_file(folder / "a.exr", header + "owner\0string\0\x7c\x7c\x7c\x7cx"s);
  const long before = peak_kilobytes();
  EXPECT_THAT(error_of([&] { read_picture(folder / "a.exr"); }), HasSubstr("is not a picture"));
  EXPECT_LT(peak_kilobytes() - before, 1 << 20);
}

INSTANTIATE_TEST_SUITE_P(Formats, PictureFile,
                         ::testing::Values(PictureFormat::png, PictureFormat::exr));

TEST(PictureFileErrors, name_the_file) {
  const TestFolder folder;
  EXPECT_THAT(error_of([&] { read_picture(folder / "none.png"); }), HasSubstr("no such file"));
  write_file(folder / "text.png", "hello");
  EXPECT_THAT(error_of([&] { read_picture(folder / "text.png"); }), HasSubstr("is not a picture"));
  EXPECT_THAT(error_of([&] { read_picture(folder.path()); }), HasSubstr("not a regular file"));
}

TEST(PictureFileErrors, one_is_read_as_what_its_name_says) {
  const TestFolder folder;
  write_picture(folder / "a.png", gradient(PictureFormat::png));
  for (const char* other : {"a.exr", "a.tif", "a.", "a"}) {
    fs::copy_file(folder / "a.png", folder / other);
    EXPECT_THAT(error_of([&] { read_picture(folder / other); }), HasSubstr("is not a picture"));
  }
  fs::copy_file(folder / "a.png", folder / "A.PNG");
  EXPECT_EQ(read_picture(folder / "A.PNG").format, PictureFormat::png);
}

TEST(PictureFileErrors, not_a_number_survives_in_an_exr) {
  const TestFolder folder;
  Picture picture = plain_picture(2, 1);
  picture.format = PictureFormat::exr;
  picture.values[1] = std::numeric_limits<float>::quiet_NaN();
  write_picture(folder / "a.exr", picture);
  EXPECT_TRUE(std::isnan(read_picture(folder / "a.exr").values[1]));
}

}  // namespace
}  // namespace collage
