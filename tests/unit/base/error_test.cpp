#include "base/error.h"

#include <array>

#include <gtest/gtest.h>

namespace collage {
namespace {

TEST(Error, SaysWhereWhatAndHowToMend) {
  EXPECT_STREQ(Error({"a/b.obj", 7}, "bad index", "export it again").what(),
               "a/b.obj:7: bad index; export it again");
  EXPECT_STREQ(Error({"a/b.obj"}, "bad index", "").what(), "a/b.obj: bad index");
  EXPECT_STREQ(Error("no scene", "name one").what(), "no scene; name one");
}

TEST(Error, IsOneLineWhateverNamesHold) {
  EXPECT_STREQ(Error({"a\nb\x1b[31m.obj"}, "gone", "").what(), "a?b?[31m.obj: gone");
}

TEST(Error, KnowsWhoIsToBlame) {
  EXPECT_EQ(Error("x", "y").blame(), Error::Blame::input);
  EXPECT_EQ(Error::outside_program("x", "y").blame(), Error::Blame::outside_program);
}

TEST(EditDistance, CountsChanges) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("abc", ""), 3U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("pakc", "pack"), 1U);
  EXPECT_EQ(edit_distance("ab", "bca"), 3U);
}

TEST(DidYouMean, NamesTheNearestOrNothing) {
  const std::array<std::string, 3> keys = {"threshold", "scaling", "seed"};
  EXPECT_EQ(did_you_mean("treshold", keys), "did you mean 'threshold'?");
  EXPECT_EQ(did_you_mean("sed", keys), "did you mean 'seed'?");
  EXPECT_EQ(did_you_mean("completely-else", keys), "");
}

}  // namespace
}  // namespace collage
