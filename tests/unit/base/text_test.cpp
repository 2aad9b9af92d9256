#include "base/text.h"

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <gtest/gtest.h>

#include "base/rng.h"

namespace collage {
namespace {

TEST(NumberText, IsTheShortest) {
  EXPECT_EQ(number_text(0.0), "0");
  EXPECT_EQ(number_text(1.5), "1.5");
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(-0.001), "-0.001");
  EXPECT_EQ(number_text(1e30), "1e+30");
}

TEST(NumberText, ReadsBackTheSame) {
  Rng rng(1, 1);
  for (int i = 0; i < 100000; ++i) {
    const double value = std::bit_cast<double>(rng.next());
    if (std::isfinite(value)) {
      EXPECT_EQ(std::strtod(number_text(value).c_str(), nullptr), value);
    }
  }
}

TEST(Grouped, PartsThousands) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1000), "1,000");
  EXPECT_EQ(grouped(334972), "334,972");
  EXPECT_EQ(grouped(std::numeric_limits<std::uint64_t>::max()), "18,446,744,073,709,551,615");
}

/// The characters of a text; U+0000 for what is none.
std::u32string characters(std::string_view text) {
  std::u32string result;
  while (!text.empty()) {
    result += take_character(text).value_or(0);
  }
  return result;
}

TEST(TakeCharacter, ReadsUtf8) {
  EXPECT_EQ(characters("aß€😀"), U"aß€😀");
  EXPECT_EQ(characters("\x7f\xc2\x80\xf4\x8f\xbf\xbf"), U"\u007f\u0080\U0010ffff");
}

TEST(TakeCharacter, RefusesWhatIsNone) {
  using namespace std::string_view_literals;
  const std::u32string none(1, U'\0');
  for (const auto& text : {"\xff"sv, "\x80"sv, "\xc0"sv, "\xe2\x82"sv, "\xe0\x80\xaf"sv,
                           "\xed\xa0\x80"sv, "\xf0\x8f\xbf\xbf"sv, "\xf4\x90\x80\x80"sv}) {
    EXPECT_EQ(characters(text), none);
  }
  EXPECT_EQ(characters("\xe2z"), none + U"z");
}

}  // namespace
}  // namespace collage
