#include "render/thumbnail.h"

#include "unit/render/support.h"

namespace collage {
namespace {

using testing::plain_picture;
using testing::TestFolder;

Picture thumbnail_of(const Picture& picture, int side) {
  const TestFolder folder;
  const std::filesystem::path path = folder / ("a" + extension(picture.format));
  write_picture(path, picture);
  return thumbnail(path, side);
}

TEST(Thumbnail, fits_the_square_and_keeps_its_proportions) {
  const Picture wide = thumbnail_of(plain_picture(200, 100), 50);
  EXPECT_EQ(wide.width, 50);
  EXPECT_EQ(wide.height, 25);
  const Picture narrow = thumbnail_of(plain_picture(1, 300), 50);
  EXPECT_EQ(narrow.width, 1);
  EXPECT_EQ(narrow.height, 50);
}

TEST(Thumbnail, is_never_larger_than_the_picture) {
  const Picture same = thumbnail_of(plain_picture(20, 10, 0.4F), 50);
  EXPECT_EQ(same.width, 20);
  EXPECT_NEAR(same.values[7], 0.4F, 1e-5);
}

TEST(Thumbnail, is_made_in_linear_light) {
  Picture checks = plain_picture(128, 128, 0.0F);
  for (std::size_t i = 0; i < checks.values.size(); ++i) {
    checks.values[i] = static_cast<float>((i / 3 + i / 3 / 128) % 2);
  }
  const Picture small = thumbnail_of(checks, 32);
  EXPECT_NEAR(small.values[3 * (16 * 32 + 16)], 0.735, 0.02) << "half the light";
}

TEST(Thumbnail, has_three_encoded_channels_whatever_the_picture_has) {
  for (const int channels : {1, 2, 3, 4}) {
    const Picture small = thumbnail_of(plain_picture(4, 4, 0.4F, channels), 9);
    EXPECT_EQ(small.channels, 3);
    EXPECT_EQ(small.values.size(), 48U);
  }
  Picture linear = plain_picture(4, 4, 0.5F);
  linear.format = PictureFormat::exr;
  EXPECT_NEAR(thumbnail_of(linear, 9).values[0], 0.7354, 1e-3);
}

}  // namespace
}  // namespace collage
