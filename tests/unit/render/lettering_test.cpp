#include "render/lettering.h"

#include "unit/render/support.h"

namespace collage {
namespace {

using testing::plain_picture;

float ink_of(const Picture& picture) {
  float ink = 0.0F;
  for (const float value : picture.values) {
    ink += 1.0F - value;
  }
  return ink;
}

Picture written(const std::string& text) {
  Picture picture = plain_picture(200, 40, 1.0F);
  Lettering(20).write(picture, 5, 30, text, 0.0F);
  return picture;
}

TEST(Lettering, longer_text_is_wider) {
  const Lettering letters(20);
  EXPECT_EQ(letters.width(""), 0);
  EXPECT_GT(letters.width("i"), 0);
  EXPECT_GT(letters.width("mm"), letters.width("ii"));
}

TEST(Lettering, a_character_of_several_bytes_is_one) {
  EXPECT_EQ(written("é").values, written("\u00e9").values);
  EXPECT_NE(written("·").values, written("7").values) << "the code point, not its low seven bits";
  const Lettering letters(20);
  EXPECT_LT(letters.width("…"), letters.width("mm"));
  EXPECT_LT(letters.width("ä"), letters.width("mm"));
}

TEST(Lettering, broken_utf_8_shows_as_boxes) {
  for (const char* text : {"\xff", "\xc3", "\xe2\x80", "\x80", "a\xc3z", "\xf0\x9f"}) {
    EXPECT_GT(ink_of(written(text)), 0.0F);
  }
}

TEST(Lettering, what_fits_stays_as_it_is) {
  const Lettering letters(20);
  EXPECT_EQ(letters.fitted("text", letters.width("text")), "text");
  EXPECT_EQ(letters.fitted("", 0), "");
}

TEST(Lettering, what_does_not_fit_ends_with_an_ellipsis) {
  const Lettering letters(20);
  const std::string text = "größer und größer und größer";
  for (int width = letters.width("…"); width < letters.width(text); ++width) {
    const std::string fitted = letters.fitted(text, width);
    EXPECT_LE(letters.width(fitted), width);
    EXPECT_THAT(fitted, ::testing::EndsWith("…"));
    EXPECT_THAT(fitted, ::testing::Not(::testing::EndsWith(" …")));
    EXPECT_EQ(fitted.find("\xc3…"), std::string::npos) << "cut within a character";
  }
}

TEST(Lettering, what_falls_outside_is_cut_off) {
  Picture picture = plain_picture(10, 10, 1.0F);
  const Lettering letters(20);
  letters.write(picture, -5, 4, "MMM", 0.0F);
  letters.write(picture, 100, 100, "MMM", 0.0F);
  EXPECT_GT(ink_of(picture), 0.0F);
}

}  // namespace
}  // namespace collage
