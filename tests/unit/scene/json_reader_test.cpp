#include "scene/json_reader.h"

#include <gmock/gmock.h>

#include "unit/scene/support.h"

namespace collage::json_reader {
namespace {

using collage::testing::error_of;
using collage::testing::TemporaryFolder;

template <class Read>
std::string problem_of(Read read) {
  try {
    read();
  } catch (const Problem& problem) {
    return problem.where + " " + problem.what;
  }
  return "";
}

TEST(JsonReader, NamesTheWayToAProblem) {
  const json root = json::parse(R"({"a": [{"b": 1}, {"b": "x"}], "c": 2})");
  const auto read = [](const json& value) {
    for_each_item(value, [](const json& item) { within(item, "b", number); });
  };
  EXPECT_EQ(problem_of([&] { within(root, "a", read); }), ".a[1].b is not a finite number");
  EXPECT_EQ(problem_of([&] { within(root, "c", read); }), ".c is not a list");
  EXPECT_EQ(problem_of([&] { within(root, "d", read); }), ".d is missing");
  EXPECT_EQ(problem_of([&] { within(json::array(), "d", read); }), ".d is missing");
}

TEST(JsonReader, ChecksValues) {
  EXPECT_EQ(positive(json(0.5)), 0.5);
  EXPECT_EQ(problem_of([] { positive(json(0)); }), " is not greater than 0");
  EXPECT_EQ(natural(json(7U)), 7U);
  EXPECT_EQ(problem_of([] { natural(json(-7)); }), " is not a whole number from 0");
  EXPECT_EQ(problem_of([] { natural(json(7.5)); }), " is not a whole number from 0");
  EXPECT_EQ(problem_of([] { text(json(7)); }), " is not text");
}

TEST(JsonReader, SaysWhatIsNotJson) {
  const TemporaryFolder folder;
  const auto error = [&](const std::string& content) {
    return error_of([&] { parsed_file(folder.write("a.json", content)); });
  };
  using ::testing::HasSubstr;
  EXPECT_THAT(error("{"), HasSubstr("a.json: is not JSON: "));
  EXPECT_THAT(error("{\"a\": 1e999}"), HasSubstr("a.json: is not JSON: "));
  EXPECT_THAT(error("{\"a\": nan}"), HasSubstr("a.json: is not JSON: "));
  EXPECT_LT(error("\"" + std::string(100000, 'x')).size(), 500U);
  EXPECT_THAT(error(std::string(1000000, '[')), HasSubstr("a.json: is not JSON: "));
}

}  // namespace
}  // namespace collage::json_reader
