#include "scene/options_reference.h"

#include <gmock/gmock.h>

#include "scene/options_table.h"
#include "unit/scene/support.h"

namespace collage {
namespace {

using ::testing::HasSubstr;

TEST(OptionsReference, ListsEachOption) {
  const std::string text = options_text();
  EXPECT_THAT(text, HasSubstr("[packing]\n  threshold = 0.02 "));
  EXPECT_THAT(text, HasSubstr("[[element]]\n  mesh "));
  for (const Option& option : options_table()) {
    EXPECT_THAT(text, HasSubstr("\n  " + option.name())) << option.key;
  }
}

TEST(OptionsReference, IsAPageOfTables) {
  const std::string page = scene_reference_markdown();
  EXPECT_THAT(page, HasSubstr("## `[packing]`\n\n| key | default | takes | meaning |\n"));
  EXPECT_THAT(page, HasSubstr("| `threshold` | `0.02` | a number from 0.0001 to 1, a fraction of "
                              "the target's longest side | radius of the smallest hole that is "
                              "still filled; by shape, of the smallest element |\n"));
  EXPECT_THAT(page, HasSubstr("| `mesh` |  | "));
  EXPECT_THAT(page, HasSubstr("is POV-Ray code, not data"));
}

}  // namespace
}  // namespace collage
