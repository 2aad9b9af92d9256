#include "scene/json_text.h"

#include "unit/scene/support.h"

namespace collage {
namespace {

TEST(JsonText, QuotesInAscii) {
  EXPECT_EQ(json_text(std::string("a\"b\\c\n\xc3\xa9")), R"("a\"b\\c\n\u00e9")");
  EXPECT_EQ(testing::error_of([] { json_text(std::string("a\xff")); }),
            "the name 'a\xff' is not UTF-8; rename the file");
}

TEST(JsonText, WritesEachKindOfValue) {
  EXPECT_EQ(json_text(OptionValue(true)), "true");
  EXPECT_EQ(json_text(OptionValue(std::int64_t{9007199254740992})), "9007199254740992");
  EXPECT_EQ(json_text(OptionValue(0.1)), "0.1");
  EXPECT_EQ(json_text(OptionValue(std::vector<double>{1, 0.5})), "[1, 0.5]");
  EXPECT_EQ(json_text(OptionValue(std::vector<std::string>{"a"})), "[\"a\"]");
}

}  // namespace
}  // namespace collage
