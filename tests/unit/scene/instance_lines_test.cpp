#include "scene/instance_lines.h"

#include <gtest/gtest.h>

namespace collage {
namespace {

std::string line(const std::string& element, const std::string& scale, const std::string& w,
                 const std::string& x) {
  return R"({"element":)" + element + R"(,"scale":)" + scale + R"(,"rotation":[)" + w +
         R"(,0,0,0],"translation":[)" + x + ",2,3]}";
}

bool reads(const std::string& lines) { return read_instance_lines(lines, 2).has_value(); }

TEST(InstanceLines, AreReadAsTheyAreWritten) {
  const Instance instance{1, 0.1, {0.6, 0.0, -0.8, 0.0}, {1e-300, -2.5, 1e300}};
  std::string text;
  append_instance(text, instance);
  const auto read = read_instance_lines(text + ",\n" + text, 2);
  ASSERT_TRUE(read);
  ASSERT_EQ(read->size(), 2U);
  for (const Instance& copy : *read) {
    EXPECT_EQ(copy.element, instance.element);
    EXPECT_EQ(copy.scale, instance.scale);
    EXPECT_EQ(copy.rotation, instance.rotation);
    EXPECT_EQ(copy.translation, instance.translation);
  }
  EXPECT_TRUE(read_instance_lines("", 1)->empty());
}

TEST(InstanceLines, OfAnyOtherFormAreLeftToJson) {
  const std::string good = line("1", "0.5", "1", "1");
  EXPECT_TRUE(reads(good));
  EXPECT_TRUE(reads(good + ",\n" + good));
  EXPECT_FALSE(reads(good + "\n" + good));
  EXPECT_FALSE(reads(good + ","));
  EXPECT_FALSE(reads(good + ",\n"));
  EXPECT_FALSE(reads(good + " "));
  EXPECT_FALSE(reads(" " + good));
  EXPECT_FALSE(reads(good.substr(0, good.size() - 1)));
  for (const char* element : {"2", "-1", "01", "1.0", "4294967296", "x", ""}) {
    EXPECT_FALSE(reads(line(element, "0.5", "1", "1"))) << element;
  }
  for (const char* scale :
       {"0", "-1", "nan", "inf", "00.5", ".5", "1.", "1.e3", "+1", "1e999", "0x1"}) {
    EXPECT_FALSE(reads(line("1", scale, "1", "1"))) << scale;
  }
  for (const char* scale : {"5", "1e-3", "1.5E+3", "0.25"}) {
    EXPECT_TRUE(reads(line("1", scale, "1", "1"))) << scale;
  }
  EXPECT_FALSE(reads(line("1", "0.5", "1.01", "1")));
  EXPECT_FALSE(reads(line("1", "0.5", "1", "infinity")));
  EXPECT_TRUE(reads(line("1", "0.5", "-1", "-0")));
}

}  // namespace
}  // namespace collage
