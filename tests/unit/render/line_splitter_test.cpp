#include "render/line_splitter.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace collage {
namespace {

using ::testing::ElementsAre;

TEST(LineSplitter, cuts_at_both_ends_of_line_and_joins_pieces) {
  std::vector<std::string> lines;
  LineSplitter splitter([&](std::string_view line) { lines.emplace_back(line); });
  splitter.append("one\ntw");
  splitter.append("o\rthree\r\n\n");
  splitter.append("rest");
  EXPECT_THAT(lines, ElementsAre("one", "two", "three"));
  splitter.finish();
  EXPECT_THAT(lines, ElementsAre("one", "two", "three", "rest"));
}

TEST(LineSplitter, bounds_the_length_of_a_line) {
  std::vector<std::size_t> sizes;
  LineSplitter splitter([&](std::string_view line) { sizes.push_back(line.size()); });
  splitter.append(std::string(LineSplitter::max_bytes + 10, 'x'));
  splitter.finish();
  EXPECT_THAT(sizes, ElementsAre(LineSplitter::max_bytes, 10));
}

}  // namespace
}  // namespace collage
