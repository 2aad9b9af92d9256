#include "render/povray.h"

#include <cstdlib>

#include "unit/render/support.h"

namespace collage {
namespace {

using ::testing::ElementsAre;
using testing::error_of;
using testing::FakeRunner;
using ::testing::HasSubstr;

class FindPovray : public ::testing::Test {
 protected:
  void SetUp() override {
    ::unsetenv("COLLAGE_POVRAY");
    ::unsetenv("COLLAGE_SANDBOX");
  }
  void TearDown() override { SetUp(); }

  std::string error() {
    return error_of([&] { find_povray(runner_, Status()); });
  }
  FakeRunner runner_;
};

TEST_F(FindPovray, reads_the_version) {
  runner_.programs["povray"] = "/usr/bin/povray";
  runner_.answers = {{.lines = {"povray: cannot open the user configuration file x: No such file",
                                "POV-Ray 3.7.0.10.unofficial", "This is an unofficial version"},
                      .exit_code = 0}};
  const Povray povray = find_povray(runner_, Status());
  EXPECT_EQ(povray.program, "/usr/bin/povray");
  EXPECT_EQ(povray.version, "3.7.0.10.unofficial");
  EXPECT_THAT(runner_.commands.at(0).arguments, ElementsAre("--version"));
}

TEST_F(FindPovray, says_how_to_install_it) {
  EXPECT_EQ(error(), "POV-Ray is not installed; run: apt-get install povray povray-includes");
}

TEST_F(FindPovray, says_which_is_too_old) {
  runner_.programs["povray"] = "/usr/bin/povray";
  runner_.answers = {{.lines = {"POV-Ray 3.6.1"}, .exit_code = 0}};
  EXPECT_EQ(error(),
            "POV-Ray 3.7 or newer is needed; /usr/bin/povray is 3.6.1; run: apt-get install povray "
            "povray-includes");
}

TEST_F(FindPovray, takes_newer_ones) {
  for (const char* line : {"POV-Ray 3.8.0-beta.2", "POV-Ray 4.0", "POV-Ray 3.10"}) {
    runner_.programs["povray"] = "/usr/bin/povray";
    runner_.answers = {{.lines = {line}, .exit_code = 0}};
    EXPECT_EQ("POV-Ray " + find_povray(runner_, Status()).version, line);
  }
}

TEST_F(FindPovray, rejects_another_program) {
  runner_.programs["povray"] = "/usr/bin/povray";
  runner_.answers = {{.lines = {"Blender 4.0"}, .exit_code = 0}};
  EXPECT_THAT(error(), HasSubstr("does not say which version of POV-Ray it is"));
}

TEST_F(FindPovray, is_asked_in_a_sandbox_where_that_works) {
  runner_.programs = {{"povray", "/usr/bin/povray"}, {"bwrap", "/usr/bin/bwrap"}};
  runner_.answers = {{.lines = {"POV-Ray 3.7.0"}, .exit_code = 0}};
  EXPECT_EQ(find_povray(runner_, Status()).sandbox, "/usr/bin/bwrap");
  EXPECT_EQ(runner_.commands.at(0).program, "/usr/bin/bwrap");
}

TEST_F(FindPovray, does_without_a_sandbox_that_does_not_work_or_is_not_wanted) {
  runner_.programs = {{"povray", "/usr/bin/povray"}, {"bwrap", "/usr/bin/bwrap"}};
  runner_.answers = {{.lines = {"bwrap: No permissions to create new namespace"}, .exit_code = 1},
                     {.lines = {"POV-Ray 3.7.0"}, .exit_code = 0},
                     {.lines = {"POV-Ray 3.7.0"}, .exit_code = 0}};
  EXPECT_EQ(find_povray(runner_, Status()).sandbox, std::nullopt);
  ::setenv("COLLAGE_SANDBOX", "no", 1);
  EXPECT_EQ(find_povray(runner_, Status()).sandbox, std::nullopt);
  EXPECT_EQ(runner_.commands.at(2).program, "/usr/bin/povray");
}

TEST_F(FindPovray, obeys_the_environment) {
  ::setenv("COLLAGE_POVRAY", "/opt/povray", 1);
  EXPECT_EQ(error(), "there is no POV-Ray at /opt/povray; check COLLAGE_POVRAY");
}

TEST(PovrayConsole, progress_never_falls_and_counts_the_pretrace_as_a_third) {
  PovrayConsole console;
  console.read_line("Parsing 7788K tokens");
  EXPECT_EQ(console.fraction(), 0.0);
  console.read_line("Performing radiosity pretrace: 60 of 120 pixels (50%)");
  EXPECT_NEAR(console.fraction(), 1.0 / 6, 1e-12);
  console.read_line("Performing radiosity pretrace: 1 of 480 pixels (1%)");
  EXPECT_NEAR(console.fraction(), 1.0 / 6, 1e-12);
  console.read_line("Rendered 1024 of 2048 pixels (50%)");
  EXPECT_NEAR(console.fraction(), 2.0 / 3, 1e-12);
  console.read_line("Rendered 2048 of 2048 pixels (100%)");
  EXPECT_NEAR(console.fraction(), 1.0, 1e-12);
}

TEST(PovrayConsole, without_pretrace_the_pixels_are_everything) {
  PovrayConsole console;
  console.read_line("Rendered 1024 of 2048 pixels (50%)");
  EXPECT_EQ(console.fraction(), 0.5);
  console.read_line("Rendered nonsense (%)");
  console.read_line("Rendered too much (150%)");
  EXPECT_EQ(console.fraction(), 0.5);
}

TEST(PovrayConsole, keeps_what_matters) {
  PovrayConsole console;
  for (const char* line :
       {"povray: cannot open the user configuration file /root/x: No such file or directory",
        "Persistence of Vision(tm) Ray Tracer Version 3.7", "Failed to parse INI file",
        "==== [Parsing...] ====", "Parsing 10K tokens", "Cannot open 'x'", "Render failed"}) {
    console.read_line(line);
  }
  EXPECT_THAT(console.remarks(),
              ElementsAre("Failed to parse INI file", "Cannot open 'x'", "Render failed"));
}

TEST(PovrayError, joins_the_wrapped_message_and_names_file_and_line) {
  const std::string fatal =
      "File: scene.pov  Line: 7\nFile Context (5 lines):\ncamera { }\nspher\n"
      "Parse Error: Expected 'object or directive', undeclared identifier 'spher' found\n"
      " instead\n\n";
  const Error error = povray_error("out/teapot", 1, fatal, {});
  EXPECT_STREQ(error.what(),
               "out/teapot/scene.pov:7: POV-Ray: Expected 'object or directive', undeclared "
               "identifier 'spher' found instead; mend the template, or make the scene again");
  EXPECT_EQ(error.blame(), Error::Blame::outside_program);
}

TEST(PovrayError, without_a_place_names_the_folder) {
  EXPECT_STREQ(povray_error("out", 1, "Parse Error: Cannot open input file.\n", {}).what(),
               "out: POV-Ray: Cannot open input file.; mend the template, or make the scene again");
}

TEST(PovrayError, without_a_message_quotes_the_console) {
  PovrayConsole console;
  console.read_line("==== [Parsing...] ====");
  console.read_line("Cannot create render state output file.");
  console.read_line("Render failed");
  EXPECT_STREQ(povray_error("out", 1, "", console).what(),
               "out: POV-Ray failed with exit code 1: Cannot create render state output file. / "
               "Render failed; check the folder's permissions and free space");
}

TEST(PovrayError, the_limit_of_memory_is_said_as_such) {
  const std::string wanted =
      "out: POV-Ray needs more memory than it may take; raise --memory-limit";
  EXPECT_THAT(
      povray_error("out", 1, "File: a.pov  Line: 7\nFatal Error: std::bad_alloc\n", {}).what(),
      HasSubstr(wanted));
  PovrayConsole console;
  console.read_line("==== [Rendering...] ====");
  console.read_line("Fatal error in renderer: Out of memory.");
  EXPECT_THAT(povray_error("out", 1, "", console).what(), HasSubstr(wanted));
}

TEST(PovrayError, being_killed_is_told_from_failing) {
  EXPECT_THAT(povray_error("out", 137, "", {}).what(), HasSubstr("ran out of memory"));
  EXPECT_THAT(povray_error("out", 139, "", {}).what(), HasSubstr("ended by signal 11"));
}

}  // namespace
}  // namespace collage
