#include "geometry/font_file.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "base/error.h"

namespace collage {
namespace {

std::string error(const std::string& font) {
  try {
    find_font(font);
  } catch (const Error& caught) {
    return caught.what();
  }
  return "";
}

TEST(FontFile, IsFoundByFamilyAndStyle) {
  EXPECT_EQ(find_font("DejaVu Sans").path.filename(), "DejaVuSans.ttf");
  EXPECT_EQ(find_font("dejavu sans:bold").path.filename(), "DejaVuSans-Bold.ttf");
  EXPECT_EQ(find_font("DejaVu Serif:style=Bold").path.filename(), "DejaVuSerif-Bold.ttf");
  EXPECT_EQ(find_font("DejaVu Sans Mono").index, 0);
}

TEST(FontFile, IsTakenByItsPath) {
  EXPECT_EQ(find_font("fonts/my.OTF").path, "fonts/my.OTF");
  EXPECT_TRUE(is_font_path("a:b.ttf"));
  EXPECT_FALSE(is_font_path("ttf"));
}

TEST(FontFile, NothingStandsInForAFont) {
  EXPECT_EQ(error("DejaVu Sanz:bold"),
            "the font family 'DejaVu Sanz' is not installed; did you mean 'DejaVu Sans'?");
  EXPECT_EQ(error("xyzzyxyzzyxyzzy"),
            "the font family 'xyzzyxyzzyxyzzy' is not installed; `fc-list : family` lists those "
            "that are");
  EXPECT_EQ(error("sans-serif").find("the font family 'sans-serif' is not installed"), 0U);
  EXPECT_THAT(error("DejaVu Serif:weight=40"),
              ::testing::StartsWith("the font 'DejaVu Serif:weight=40' is not installed in that "
                                    "style; its styles are Bold, "));
}

TEST(FontFile, PatternsThatNameNoneAreRefused) {
  const std::vector<std::string> fonts{"",          ":bold", ":::", "a\nb", std::string(300, 'x'),
                                       "a:slant=(("};
  for (const std::string& font : fonts) {
    EXPECT_NE(error(font), "") << font;
  }
  EXPECT_THAT(error(""), ::testing::StartsWith("'' does not name a font; write a family"));
}

}  // namespace
}  // namespace collage
