#include "cli/sweep.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"

namespace collage {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

TEST(Sweep, PartsValuesAtCommasOutsideOfLists) {
  const SweepOption option = parse_sweep_option("element.0.scales=[1, 0.5],[0.7],\"a,b\"");
  EXPECT_EQ(option.key, "element.0.scales");
  EXPECT_THAT(option.values, ElementsAre("[1, 0.5]", "[0.7]", "\"a,b\""));
  EXPECT_THAT(parse_sweep_option("a=b=c").values, ElementsAre("b=c"));
}

TEST(Sweep, RefusesWhatSetsNothing) {
  for (const char* text : {"", "packing.seed", "=1", "a=", "a=1,", "a=,1"}) {
    EXPECT_THROW(parse_sweep_option(text), Error) << text;
  }
}

TEST(Sweep, ReadsRangesAndListsOfSeeds) {
  EXPECT_THAT(parse_sweep_seeds("1..4").values, ElementsAre("1", "2", "3", "4"));
  EXPECT_THAT(parse_sweep_seeds("7").values, ElementsAre("7"));
  EXPECT_THAT(parse_sweep_seeds("3,1").values, ElementsAre("3", "1"));
  EXPECT_THAT(parse_sweep_seeds("18446744073709551615..18446744073709551615").values,
              ElementsAre("18446744073709551615"));
  for (const char* text : {"", "a", "4..1", "1..", "..2", "1...3", "1,", "-1", "1..5000"}) {
    EXPECT_THROW(parse_sweep_seeds(text), Error) << text;
  }
}

TEST(Sweep, TriesAllCombinationsTheLastOptionFastest) {
  EXPECT_THAT(combinations({{"a", {"1", "2"}}, {"b", {"x", "y"}}}),
              ElementsAre(ElementsAre("a=1", "b=x"), ElementsAre("a=1", "b=y"),
                          ElementsAre("a=2", "b=x"), ElementsAre("a=2", "b=y")));
  EXPECT_THAT(combinations({}), ElementsAre(SizeIs(0)));
}

}  // namespace
}  // namespace collage
