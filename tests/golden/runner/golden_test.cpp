#include "golden/runner/golden.h"

#include <cstdlib>

#include "unit/render/support.h"

namespace collage {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using testing::error_of;
using ::testing::HasSubstr;
using testing::plain_picture;
using testing::TestFolder;

/// Golden pictures that a command only has to copy.
class Golden : public ::testing::Test {
 protected:
  Golden() {
    ::unsetenv("CI");
    write_file(folder_ / "bin/collage", "");
    add("lamp", plain_picture(8, 6));
  }

  void add(const std::string& name, const Picture& reference) {
    write_file(folder_ / ("cases/" + name + "/command"), "cp made.png picture.png\n");
    write_picture(folder_ / ("cases/" + name + "/made.png"), plain_picture(8, 6));
    write_picture(folder_ / ("cases/" + name + "/reference.png"), reference);
  }

  int run(const std::vector<std::string>& names = {},
          GoldenRun::Update update = GoldenRun::Update::no) {
    said_.clear();
    SystemRunner runner;
    Status status;
    return run_golden({folder_ / "bin/collage", folder_ / "cases", folder_ / "out", names, update},
                      runner, status,
                      [this](std::string_view line) { said_.append(line).append("\n"); });
  }

  [[nodiscard]] std::string reference(const std::string& name = "lamp") const {
    return read_file(folder_ / ("cases/" + name + "/reference.png"));
  }

  TestFolder folder_;
  std::string said_;
};

/// One pixel is off by 40 of 255.
Picture with_wrong_pixel() {
  Picture picture = plain_picture(8, 6);
  picture.values[3 * 11] += 40.0F / 255.0F;
  return picture;
}

TEST_F(Golden, equal_pictures_pass) {
  EXPECT_EQ(run(), 0) << said_;
  EXPECT_THAT(said_, HasSubstr("1 of 1 golden pictures pass; see "));
  EXPECT_TRUE(fs::exists(folder_ / "out/index.html"));
}

TEST_F(Golden, one_wrong_pixel_fails_and_says_where_and_what_to_do) {
  add("lamp", with_wrong_pixel());
  add("urn", plain_picture(8, 6));
  EXPECT_EQ(run(), 1);
  EXPECT_THAT(said_, HasSubstr("lamp: pixel 3, 1 differs by 0.1569; at most 0.012 is allowed\n"
                               "  kept in " +
                               (folder_ / "out/lamp").string() + "\n"));
  EXPECT_THAT(said_, HasSubstr("1 of 2 golden pictures pass"));
  EXPECT_THAT(said_, HasSubstr("./run golden --update lamp\n"));
  for (const char* name : {"picture.png", "reference.png", "difference.png"}) {
    EXPECT_TRUE(fs::exists(folder_ / "out/lamp" / name)) << name;
  }
  EXPECT_THAT(read_file(folder_ / "out/index.html"), HasSubstr("lamp/difference.png"));
}

TEST_F(Golden, another_size_or_channel_count_fails_whatever_the_tolerance) {
  write_file(folder_ / "cases/lamp/tolerance",
             "# anything goes\nfail 1\nfailing-share 1\nhard-fail 1\n");
  add("lamp", with_wrong_pixel());
  EXPECT_EQ(run(), 0) << said_;
  add("lamp", plain_picture(6, 8));
  EXPECT_EQ(run(), 1);
  EXPECT_THAT(said_, HasSubstr("lamp: the reference has 6 x 8 pixels, the picture 8 x 6\n"));
  add("lamp", plain_picture(8, 6, 0.4F, 4));
  EXPECT_EQ(run(), 1);
  EXPECT_THAT(said_, HasSubstr("lamp: the reference has 4 channels, the picture 3\n"));
}

TEST_F(Golden, a_missing_or_broken_reference_fails) {
  const fs::path reference = folder_ / "cases/lamp/reference.png";
  testing::cut_in_half(reference);
  EXPECT_EQ(run(), 1);
  EXPECT_THAT(said_, HasSubstr("reference.png"));
  fs::remove(reference);
  EXPECT_EQ(run(), 1);
  EXPECT_THAT(said_, HasSubstr("lamp: there is no reference.png\n"));
}

TEST_F(Golden, a_command_that_fails_or_leaves_no_picture_fails) {
  write_file(folder_ / "cases/lamp/command", "echo no light\nexit 3\n");
  EXPECT_EQ(run(), 1);
  EXPECT_THAT(said_, HasSubstr("lamp: its command ended with exit code 3: no light\n"));
  write_file(folder_ / "cases/lamp/command", "true\n");
  EXPECT_EQ(run({"lamp"}, GoldenRun::Update::yes), 1);
  EXPECT_THAT(said_, HasSubstr("lamp: its command left no picture.png\n"));
}

TEST_F(Golden, an_earlier_picture_does_not_stand_in_for_a_new_one) {
  EXPECT_EQ(run(), 0);
  write_file(folder_ / "cases/lamp/command", "true\n");
  EXPECT_EQ(run(), 1);
}

TEST_F(Golden, update_rewrites_what_failed_or_is_missing_and_nothing_else) {
  Picture passes = plain_picture(8, 6);
  passes.key = "equal pixels, other bytes";
  add("fine", passes);
  add("lamp", with_wrong_pixel());
  add("new", plain_picture(8, 6));
  add("other", with_wrong_pixel());
  fs::remove(folder_ / "cases/new/reference.png");
  const std::string fine = reference("fine");
  const std::string other = reference("other");

  EXPECT_EQ(run({"fine", "lamp", "new"}, GoldenRun::Update::yes), 0) << said_;
  EXPECT_THAT(
      said_,
      HasSubstr(
          "fine: passes, its reference stays\nlamp: has a new reference; before: pixel 3, 1"));
  EXPECT_EQ(reference("fine"), fine);
  EXPECT_EQ(reference("other"), other);
  EXPECT_EQ(run({"fine", "lamp", "new"}), 0) << said_;
}

TEST_F(Golden, update_is_refused_in_continuous_integration) {
  add("lamp", with_wrong_pixel());
  const std::string before = reference();
  ::setenv("CI", "true", 1);
  EXPECT_THAT(error_of([this] { run({}, GoldenRun::Update::yes); }),
              HasSubstr("references are not rewritten in continuous integration"));
  EXPECT_EQ(run(), 1);
  EXPECT_EQ(reference(), before);
}

TEST_F(Golden, names_that_are_not_there_are_errors) {
  EXPECT_THAT(error_of([this] { run({"lmap"}); }),
              HasSubstr("there is no golden picture 'lmap'; did you mean 'lamp'?"));
}

TEST_F(Golden, a_tolerance_needs_known_keys_and_a_reason) {
  const fs::path file = folder_ / "cases/lamp/tolerance";
  EXPECT_EQ(read_tolerance(file).hard_fail, 0.012);
  write_file(file, "# edges of glass\nhard-fail 0.1\n");
  EXPECT_EQ(read_tolerance(file).hard_fail, 0.1);
  EXPECT_EQ(read_tolerance(file).fail, 0.004);
  write_file(file, "hard-fail 0.1\n");
  EXPECT_THAT(error_of([&] { read_tolerance(file); }), HasSubstr("gives no reason"));
  for (const char* line : {"hardfail 0.1", "fail", "fail x", "fail 0.1 0.2", ""}) {
    write_file(file, std::string("# reason\n") + line + "\n");
    EXPECT_THAT(error_of([&] { read_tolerance(file); }), HasSubstr(":2: is no threshold")) << line;
  }
}

TEST_F(Golden, cases_are_the_folders_with_a_command) {
  write_file(folder_ / "cases/runner/main.cpp", "");
  add("chair", plain_picture(8, 6));
  std::vector<std::string> names;
  for (const GoldenCase& golden : find_golden_cases(folder_ / "cases", {})) {
    names.push_back(golden.name);
  }
  EXPECT_THAT(names, ElementsAre("chair", "lamp"));
}

}  // namespace
}  // namespace collage
