#include "geometry/font_outline.h"

#include <cmath>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <unistd.h>

#include "base/error.h"
#include "base/file.h"
#include "base/rng.h"
#include "unit/geometry/test_letters.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

std::vector<Contour> outlines(const std::string& text, double tolerance = 0.001) {
  return read_outlines(find_font("DejaVu Sans"), text, tolerance);
}

Box box_of(const std::vector<Contour>& contours) {
  Box box;
  for (const Contour& contour : contours) {
    for (const dvec2& point : contour) {
      box.include({point, 0.0});
    }
  }
  return box;
}

template <class Action>
std::string error_of(const Action& action) {
  try {
    action();
  } catch (const Error& caught) {
    return caught.what();
  }
  return "";
}

TEST(FontOutline, CapitalsAreOneHigh) {
  const Box box = box_of(outlines("H"));
  EXPECT_EQ(box.min.y, 0.0);
  EXPECT_EQ(box.max.y, 1.0);
  EXPECT_LT(box_of(outlines("g")).min.y, -0.1);
  EXPECT_TRUE(outlines(" ").empty());
}

TEST(FontOutline, ContoursAreThoseOfTheLetter) {
  EXPECT_EQ(outlines("B").size(), 3U);
  EXPECT_EQ(outlines("i").size(), 2U);
  EXPECT_EQ(outlines("ö").size(), 4U);
  EXPECT_EQ(outlines("%").size(), 5U);
  const auto o = outlines("O");
  ASSERT_EQ(o.size(), 2U);
  EXPECT_LT(area(o[0]) * area(o[1]), 0.0);  // the hole runs the other way
}

TEST(FontOutline, CurvesKeepToTheTolerance) {
  const auto fine = outlines("O", 1e-6);
  const double exact = inked_area(fine, 20000);
  for (const double tolerance : {0.02, 0.005, 0.001}) {
    const auto rough = outlines("O", tolerance);
    EXPECT_LT(rough[0].size(), fine[0].size());
    // Both contours of the O are about 3 long; chords lie to one side of the curve.
    EXPECT_LT(std::abs(inked_area(rough, 20000) - exact), 6.0 * tolerance);
  }
}

TEST(FontOutline, LettersFollowEachOtherAndAreKerned) {
  const double a = box_of(outlines("A")).max.x;
  const double both = box_of(outlines("AV")).max.x;
  EXPECT_GT(both, 1.5 * a);
  EXPECT_EQ(outlines("AA").size(), 4U);
  // An A and a V lean on each other.
  const double straight = box_of(outlines("HV")).max.x - box_of(outlines("HH")).max.x;
  const double kerned = box_of(outlines("AV")).max.x - box_of(outlines("AH")).max.x;
  EXPECT_LT(kerned, straight - 0.02);
}

TEST(FontOutline, SaysWhatTheFontHasNot) {
  const std::string file = find_font("DejaVu Sans").path.string();
  EXPECT_EQ(error_of([] { outlines("a\U0001F9FF"); }),
            file +
                ": has no glyph for U+1F9FF; choose a font that has; `fc-list :charset=1f9ff` "
                "lists them");
  EXPECT_EQ(error_of([] { outlines("\u4e00"); }),
            file +
                ": has no glyph for U+4E00; choose a font that has; `fc-list :charset=4e00` "
                "lists them");
}

TEST(FontOutline, RefusesTextThatIsNone) {
  EXPECT_EQ(error_of([] { outlines("a\xff"); }),
            "the text for letters is not UTF-8; write it as UTF-8");
  EXPECT_EQ(error_of([] { outlines("a\nb"); }),
            "the text for letters holds the control character U+000A; leave it out");
  EXPECT_EQ(error_of([] { outlines("\u009f"); }),
            "the text for letters holds the control character U+009F; leave it out");
  EXPECT_EQ(error_of([] { outlines(std::string(201, 'a')); }),
            "the text for letters has 201 characters; shorten it to 200");
  EXPECT_EQ(error_of([] { outlines(std::string(200, 'a')); }), "");
}

class DamagedFont : public ::testing::Test {
 protected:
  ~DamagedFont() override { fs::remove(path_); }
  fs::path path_ = fs::temp_directory_path() / fmt_name();

 private:
  static std::string fmt_name() { return "collage-font-" + std::to_string(::getpid()) + ".ttf"; }
};

TEST_F(DamagedFont, IsRefusedOrReadButNeverMore) {
  const std::string whole = read_file(find_font("DejaVu Sans Mono").path);
  Rng rng(7, 7);
  int read = 0;
  for (int i = 0; i < 60; ++i) {
    std::string bytes = i % 4 == 0 ? whole.substr(0, rng.below(whole.size())) : whole;
    for (int k = 0; k < 400 && !bytes.empty(); ++k) {
      // In the tables' directory as well as in the glyphs.
      bytes[rng.below(k < 3 ? std::min<std::size_t>(400, bytes.size()) : bytes.size())] =
          static_cast<char>(rng.below(256));
    }
    write_file(path_, bytes);
    const std::string error = error_of([&] {
      united(read_outlines({path_, 0}, "Bag&%@", 0.001));
      ++read;
    });
    EXPECT_TRUE(error.empty() || error.starts_with(path_.string())) << error;
  }
  EXPECT_GT(read, 0);
  EXPECT_LT(read, 60);
}

TEST_F(DamagedFont, IsNoFont) {
  write_file(path_, "no font");
  EXPECT_EQ(
      error_of([&] {
        read_outlines({path_, 0}, "a", 0.001);
      }),
      path_.string() + ": is not a font that can be read; check the file, or choose another font");
  write_file(path_, "");
  EXPECT_THAT(error_of([&] {
                read_outlines({path_, 0}, "a", 0.001);
              }),
              ::testing::HasSubstr("is not a font that can be read"));
  EXPECT_THAT(error_of([&] {
                read_outlines({"no-such.ttf", 0}, "a", 0.001);
              }),
              ::testing::HasSubstr("no such file"));
}

}  // namespace
}  // namespace collage
