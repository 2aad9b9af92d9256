#include "render/embedded_picture.h"

#include <cmath>

#include "unit/render/support.h"

namespace collage {
namespace {

using testing::error_of;
using ::testing::HasSubstr;
using testing::plain_picture;
using ::testing::StartsWith;
using testing::TestFolder;

/// Like a rendering: no two pixels are quite the same.
Picture noisy_picture(int width, int height) {
  Picture picture = plain_picture(width, height);
  for (std::size_t i = 0; i < picture.values.size(); ++i) {
    picture.values[i] = static_cast<float>(0.5 + 0.4 * std::sin(static_cast<double>(i * i)));
  }
  return picture;
}

EmbeddedPicture embedded(const TestFolder& folder, const Picture& picture, int side) {
  write_picture(folder / "a.png", picture);
  return embedded_picture(folder / "a.png", side);
}

// RFC 4648, section 10.
TEST(Base64, encodes_the_vectors_of_its_definition) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xFB\xFF"), "+/8=");
}

TEST(EmbeddedPicture, keeps_a_flat_drawing_and_makes_a_rendering_small) {
  const TestFolder folder;
  const std::string flat = embedded(folder, plain_picture(64, 64), 64).uri;
  EXPECT_THAT(flat, StartsWith("data:image/png;base64,iVBORw0KGgo"));
  const std::string noisy = embedded(folder, noisy_picture(64, 64), 64).uri;
  EXPECT_THAT(noisy, StartsWith("data:image/jpeg;base64,/9j/"));
  EXPECT_LT(noisy.size(), std::filesystem::file_size(folder / "a.png"));
}

TEST(EmbeddedPicture, fits_its_square) {
  const TestFolder folder;
  const EmbeddedPicture picture = embedded(folder, noisy_picture(80, 40), 20);
  EXPECT_EQ(picture.width, 20);
  EXPECT_EQ(picture.height, 10);
}

TEST(EmbeddedPicture, equal_pictures_give_equal_text) {
  const TestFolder folder;
  Picture picture = noisy_picture(32, 32);
  const std::string one = embedded(folder, picture, 32).uri;
  picture.key = "another";
  EXPECT_EQ(embedded(folder, picture, 32).uri, one);
}

TEST(EmbeddedPicture, says_what_is_missing) {
  EXPECT_THAT(error_of([] { embedded_picture("none.png", 9); }), HasSubstr("none.png"));
}

}  // namespace
}  // namespace collage
