#include "scene/pov_text.h"

#include "unit/scene/support.h"

namespace collage {
namespace {

TEST(PovText, ReducesNamesToPlainOnes) {
  EXPECT_EQ(plain_name("tea-cup_2.obj"), "tea-cup_2.obj");
  EXPECT_EQ(plain_name("a\n#debug \"x\" */ \\ \xc3\xa9"), "a__debug _x_ __ _ __");
  EXPECT_EQ(plain_name(std::string(1000, 'a')).size(), 60U);
}

TEST(PovText, EscapesStrings) {
  EXPECT_EQ(pov_string("studio.inc"), "\"studio.inc\"");
  EXPECT_EQ(pov_string("a\"b\\c\n"), R"("a\"b\\c_")");
}

TEST(PovText, WritesShortNumbers) { EXPECT_EQ(pov_vector({0.1, -2.0, 1e30}), "<0.1, -2, 1e+30>"); }

}  // namespace
}  // namespace collage
