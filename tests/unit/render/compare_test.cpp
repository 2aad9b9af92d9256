#include "render/compare.h"

#include <limits>

#include "unit/render/support.h"

namespace collage {
namespace {

using testing::cut_in_half;
using testing::error_of;
using ::testing::HasSubstr;
using testing::plain_picture;
using testing::TestFolder;

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr float step = 1.0F / 255.0F;

class Compare : public ::testing::Test {
 protected:
  Comparison compare(const Picture& reference, const Picture& picture) {
    write_picture(path("reference", reference), reference);
    write_picture(path("picture", picture), picture);
    return compare_pictures(path("reference", reference), path("picture", picture));
  }
  std::filesystem::path path(const std::string& stem, const Picture& picture) const {
    return folder_ / (stem + extension(picture.format));
  }
  /// 100 x 100 pixels, so that two may fail.
  static Picture large() { return plain_picture(100, 100, 100 * step); }
  static Picture small_exr(float value) {
    Picture picture = plain_picture(2, 2, 0.5F);
    picture.format = PictureFormat::exr;
    picture.values[5] = value;
    return picture;
  }
  TestFolder folder_;
};

TEST_F(Compare, equal_pixels_are_the_same) {
  const Comparison comparison = compare(large(), large());
  EXPECT_EQ(comparison.verdict, Verdict::same);
  EXPECT_EQ(comparison.reason, "all pixels are equal");
  EXPECT_EQ(comparison.numbers->max_error, 0.0);
  EXPECT_EQ(comparison.numbers->failing_pixels, 0);
  EXPECT_EQ(comparison.numbers->pixels, 10000);
  EXPECT_FALSE(comparison.numbers->psnr_decibels);
}

TEST_F(Compare, metadata_do_not_matter) {
  Picture other = large();
  other.key = "another";
  EXPECT_EQ(compare(large(), other).verdict, Verdict::same);
}

TEST_F(Compare, one_step_of_eight_bits_is_within_tolerance_everywhere) {
  const Comparison comparison = compare(large(), plain_picture(100, 100, 101 * step));
  EXPECT_EQ(comparison.verdict, Verdict::within_tolerance);
  EXPECT_NEAR(comparison.numbers->mean_error, step, 1e-6);
  EXPECT_NEAR(*comparison.numbers->psnr_decibels, 48.13, 0.01);
}

TEST_F(Compare, two_of_ten_thousand_pixels_may_fail_and_three_may_not) {
  Picture picture = large();
  picture.values[30] = 102 * step;
  picture.values[61] = picture.values[60] = 102 * step;  // two channels of one pixel
  Comparison comparison = compare(large(), picture);
  EXPECT_EQ(comparison.verdict, Verdict::within_tolerance);
  EXPECT_EQ(comparison.numbers->failing_pixels, 2);
  picture.values[90] = 102 * step;
  comparison = compare(large(), picture);
  EXPECT_EQ(comparison.verdict, Verdict::differs);
  EXPECT_EQ(comparison.reason, "3 of 10,000 pixels differ by more than 0.004; at most 2 may");
}

TEST_F(Compare, no_pixel_may_differ_by_much) {
  Picture picture = large();
  picture.values[3 * (7 * 100 + 5) + 1] = 104 * step;
  const Comparison comparison = compare(large(), picture);
  EXPECT_EQ(comparison.verdict, Verdict::differs);
  EXPECT_EQ(comparison.reason, "pixel 5, 7 differs by 0.01569; at most 0.012 is allowed");
  EXPECT_EQ(comparison.numbers->max_x, 5);
  EXPECT_EQ(comparison.numbers->max_y, 7);
}

TEST_F(Compare, another_size_differs_whatever_the_pixels) {
  const Comparison comparison = compare(large(), plain_picture(100, 99, 100 * step));
  EXPECT_EQ(comparison.verdict, Verdict::differs);
  EXPECT_EQ(comparison.reason, "the reference has 100 x 100 pixels, the picture 100 x 99");
  EXPECT_FALSE(comparison.numbers);
}

TEST_F(Compare, another_number_of_channels_differs) {
  const Comparison comparison = compare(large(), plain_picture(100, 100, 100 * step, 4));
  EXPECT_EQ(comparison.verdict, Verdict::differs);
  EXPECT_EQ(comparison.reason, "the reference has 3 channels, the picture 4");
}

TEST_F(Compare, a_png_is_not_an_exr) {
  Picture linear = large();
  linear.format = PictureFormat::exr;
  EXPECT_THAT(compare(large(), linear).reason, HasSubstr("sRGB-encoded"));
}

TEST_F(Compare, a_value_that_is_not_a_number_differs_even_from_itself) {
  for (const float bad : {not_a_number, infinite, -infinite}) {
    EXPECT_EQ(compare(small_exr(0.5F), small_exr(bad)).verdict, Verdict::differs);
    EXPECT_EQ(compare(small_exr(bad), small_exr(0.5F)).verdict, Verdict::differs);
    EXPECT_EQ(compare(small_exr(bad), small_exr(bad)).verdict, Verdict::differs);
  }
  EXPECT_EQ(compare(small_exr(0.5F), small_exr(not_a_number)).reason,
            "0 values of the reference and 1 of the picture are infinite or not a number");
}

TEST_F(Compare, a_missing_or_broken_picture_is_an_error) {
  write_picture(folder_ / "a.png", large());
  write_picture(folder_ / "b.png", large());
  cut_in_half(folder_ / "b.png");
  const auto error = [&](const char* reference, const char* picture) {
    return error_of([&] { compare_pictures(folder_ / reference, folder_ / picture); });
  };
  EXPECT_THAT(error("none.png", "a.png"), HasSubstr("none.png: no such file"));
  EXPECT_THAT(error("a.png", "none.png"), HasSubstr("none.png: no such file"));
  EXPECT_THAT(error("a.png", "b.png"), HasSubstr("b.png: is not a whole picture"));
}

TEST_F(Compare, the_difference_picture_is_amplified) {
  Picture picture = large();
  picture.values[30] = 98 * step;
  picture.values[33] = 200 * step;
  write_picture(folder_ / "a.png", large());
  write_picture(folder_ / "b.png", picture);
  write_difference(folder_ / "a.png", folder_ / "b.png", folder_ / "d.png", 16);
  const Picture difference = read_picture(folder_ / "d.png");
  EXPECT_EQ(difference.values[0], 0.0F);
  EXPECT_NEAR(difference.values[30], 32 * step, 1e-5);
  EXPECT_EQ(difference.values[33], 1.0F);
}

TEST_F(Compare, the_difference_of_transparent_pictures_can_be_seen) {
  write_picture(folder_ / "a.png", plain_picture(2, 2, 0.2F, 4));
  write_difference(folder_ / "a.png", folder_ / "a.png", folder_ / "d.png");
  EXPECT_EQ(read_picture(folder_ / "d.png").values[3], 1.0F);
}

TEST_F(Compare, there_is_no_difference_picture_of_two_sizes) {
  write_picture(folder_ / "a.png", plain_picture(3, 2));
  write_picture(folder_ / "b.png", plain_picture(2, 3));
  EXPECT_THAT(
      error_of([&] { write_difference(folder_ / "a.png", folder_ / "b.png", folder_ / "d.png"); }),
      HasSubstr("differs from its reference in size or channels"));
}

}  // namespace
}  // namespace collage
