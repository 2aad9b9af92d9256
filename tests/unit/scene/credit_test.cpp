#include "scene/credit.h"

#include <gtest/gtest.h>

#include "unit/scene/support.h"

namespace collage {
namespace {

using testing::error_of;

TEST(Credit, StandsBesideTheMesh) {
  const testing::TemporaryFolder folder;
  folder.write("cup.credit.json",
               R"({"title": "Cup \u20ac", "author": "A. B.", "licence": "CC0", "link": ""})");
  const auto credit = read_credit(folder.path() / "cup.obj");
  ASSERT_TRUE(credit);
  EXPECT_EQ(credit->title, "Cup €");
  EXPECT_EQ(credit->author, "A. B.");
  EXPECT_EQ(credit->licence, "CC0");
  EXPECT_EQ(credit->link, "");
  EXPECT_FALSE(read_credit(folder.path() / "hat.obj"));
}

TEST(Credit, IsRefusedWhereItIsSomethingElse) {
  const testing::TemporaryFolder folder;
  const auto error = [&](const std::string& content) {
    folder.write("cup.credit.json", content);
    return error_of([&] { read_credit(folder.path() / "cup.obj"); });
  };
  const std::string file = (folder.path() / "cup.credit.json").string();
  const std::string remedy = "; mend or remove it; it says whose work the mesh is";
  EXPECT_EQ(error(R"({"title": "Cup"})"), file + ": author is missing" + remedy);
  EXPECT_EQ(error(R"({"title": 1})"), file + ": title is not text" + remedy);
  EXPECT_EQ(error("{").substr(0, file.size() + 13), file + ": is not JSON");
}

}  // namespace
}  // namespace collage
