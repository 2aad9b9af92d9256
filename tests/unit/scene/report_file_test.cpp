#include "scene/report_file.h"

#include <gmock/gmock.h>

#include "unit/scene/support.h"

namespace collage {
namespace {

using testing::TemporaryFolder;

Report some_report() {
  Report report;
  report.seed = 7;
  report.instances = 1433;
  report.fill = 0.7287;
  report.fill_by_voxels = 0.71;
  report.fill_by_spheres = 0.74;
  report.largest_hole = 0.0199;
  report.voxels = {104, 66, 84};
  report.seconds = {1.5, 2.25, 3.125, 0.5, 60.0};
  report.elements = {{"teacup", 312, 1400}, {"hat", 1000, 33}};
  return report;
}

TEST(ReportFile, ReadsBackWhatItWrote) {
  const TemporaryFolder folder;
  const Report report = some_report();
  write_report(folder.path() / "report.json", report);
  const Report copy = read_report(folder.path() / "report.json");
  EXPECT_EQ(copy.seed, 7U);
  EXPECT_EQ(copy.instances, 1433U);
  EXPECT_EQ(copy.fill, 0.7287);
  EXPECT_EQ(copy.fill_by_voxels, 0.71);
  EXPECT_EQ(copy.fill_by_spheres, 0.74);
  EXPECT_EQ(copy.largest_hole, 0.0199);
  EXPECT_EQ(copy.voxels, report.voxels);
  EXPECT_EQ(copy.seconds.prepare, 1.5);
  EXPECT_EQ(copy.seconds.render, 60.0);
  ASSERT_EQ(copy.elements.size(), 2U);
  EXPECT_EQ(copy.elements[1].name, "hat");
  EXPECT_EQ(copy.elements[1].faces, 1000U);
  EXPECT_EQ(copy.elements[1].instances, 33U);
}

TEST(ReportFile, MarksWhatWasEndedEarly) {
  const TemporaryFolder folder;
  Report report = some_report();
  write_report(folder.path() / "report.json", report);
  EXPECT_EQ(read_report(folder.path() / "report.json").stopped, std::nullopt);
  EXPECT_THAT(report_text(report), ::testing::Not(::testing::HasSubstr("complete")));
  report.stopped = "time limit";
  write_report(folder.path() / "report.json", report);
  EXPECT_EQ(read_report(folder.path() / "report.json").stopped, "time limit");
  EXPECT_THAT(report_text(report), ::testing::HasSubstr("ended by time limit"));
}

TEST(ReportFile, SaysWhatIsWrong) {
  const TemporaryFolder folder;
  const auto path = folder.write("report.json", R"({"seed": 1, "instances": -1})");
  EXPECT_EQ(
      testing::error_of([&] { read_report(path); }),
      path.string() +
          ": instances is not a whole number from 0; make the folder again with collage make");
}

TEST(ReportFile, ShowsATable) {
  EXPECT_EQ(report_text(some_report()),
            "element       faces   instances  faces in all\n"
            "teacup          312       1,400       436,800\n"
            "hat           1,000          33        33,000\n"
            "all                       1,433       469,800\n"
            "\n"
            "voxels                  104 x 66 x 84 = 576,576\n"
            "fill by volume          72.87 %\n"
            "fill by voxels          71.00 %\n"
            "largest hole left       1.99 % of the longest side\n"
            "seconds                 prepare 1.50, place 2.25, update 3.12, write 0.50, render "
            "60.00\n"
            "seed                    7\n");
}

TEST(ReportFile, ShowsNamesWithoutControlCharacters) {
  Report report = some_report();
  report.elements[0].name = "\x1b[2Jcup";
  EXPECT_THAT(report_text(report), ::testing::HasSubstr("?[2Jcup"));
}

}  // namespace
}  // namespace collage
