#include "scene/option.h"

#include <limits>

#include "unit/scene/support.h"

namespace collage {
namespace {

TEST(Option, ShowsValuesAsSceneFilesHaveThem) {
  EXPECT_EQ(shown(true), "true");
  EXPECT_EQ(shown(std::int64_t{36}), "36");
  EXPECT_EQ(shown(0.0001), "0.0001");
  EXPECT_EQ(shown(1e300), "1e+300");
  EXPECT_EQ(shown(-std::numeric_limits<double>::infinity()), "-inf");
  EXPECT_EQ(shown(std::string("studio")), "\"studio\"");
  EXPECT_EQ(shown(std::vector<double>{1, 0.7}), "[1, 0.7]");
  EXPECT_EQ(shown(std::vector<std::string>{"a", "b"}), "[\"a\", \"b\"]");
}

TEST(Option, SaysWhatItTakes) {
  Option option;
  option.key = "packing.scaling";
  option.form = TextForm::word;
  option.words = {"a", "b", "c"};
  EXPECT_EQ(accepted_values(option), "\"a\", \"b\" or \"c\"");
  option.kind = OptionKind::number;
  option.maximum = 1.0;
  option.unit = "a fraction";
  EXPECT_EQ(accepted_values(option), "a number from 0 to 1, a fraction");
}

TEST(Option, KnowsItsNames) {
  Option option;
  option.key = "packing.seed";
  EXPECT_EQ(option.section(), "packing");
  EXPECT_EQ(option.name(), "seed");
  EXPECT_EQ(option.full_key(3), "packing.seed");
  option.key = "element.color";
  EXPECT_EQ(option.full_key(3), "element.3.color");
}

}  // namespace
}  // namespace collage
