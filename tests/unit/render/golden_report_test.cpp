#include "render/golden_report.h"

#include "unit/render/support.h"

namespace collage {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::TestFolder;

std::string report(const TestFolder& folder, const std::vector<GoldenRow>& rows) {
  write_golden_report(rows, "./run test --update <studio>", folder / "out/index.html");
  return read_file(folder / "out/index.html");
}

Comparison comparison(Verdict verdict) {
  Comparison::Numbers numbers;
  numbers.max_error = 0.25;
  numbers.max_x = 3;
  numbers.pixels = 48;
  return {verdict, "pixel 3, 0 differs", numbers};
}

TEST(GoldenReport, shows_three_pictures_by_relative_links_with_the_numbers) {
  const TestFolder folder;
  const std::string page = report(folder, {{.name = "studio",
                                            .reference = folder / "ref/a 1%.png",
                                            .picture = folder / "out/new.png",
                                            .difference = folder / "out/d\"'.png",
                                            .comparison = comparison(Verdict::differs)}});
  EXPECT_THAT(page, HasSubstr("src=\"../ref/a%201%25.png\""));
  EXPECT_THAT(page, HasSubstr("src=\"new.png\""));
  EXPECT_THAT(page, HasSubstr("src=\"d%22%27.png\""));
  EXPECT_THAT(page, HasSubstr("pixel 3, 0 differs"));
  EXPECT_THAT(page, HasSubstr("maximum 0.25 at 3, 0"));
  EXPECT_THAT(page, HasSubstr("0 of 1 pass"));
}

TEST(GoldenReport, escapes_text_and_prints_the_update_command) {
  const TestFolder folder;
  const std::string page = report(
      folder, {{.name = "<b>&", .comparison = std::nullopt, .problem = "there is no <ref>"}});
  EXPECT_THAT(page, HasSubstr("&lt;b&gt;&amp;"));
  EXPECT_THAT(page, HasSubstr("there is no &lt;ref&gt;"));
  EXPECT_THAT(page, HasSubstr("<code>./run test --update &lt;studio&gt;</code>"));
  EXPECT_THAT(page, Not(HasSubstr("<b>")));
}

TEST(GoldenReport, has_nothing_to_update_where_all_pass) {
  const TestFolder folder;
  const std::string page =
      report(folder, {{.name = "studio", .comparison = comparison(Verdict::within_tolerance)}});
  EXPECT_THAT(page, HasSubstr("1 of 1 pass."));
  EXPECT_THAT(page, Not(HasSubstr("--update")));
}

TEST(GoldenReport, failures_come_first) {
  const TestFolder folder;
  const std::string page =
      report(folder, {{.name = "fine", .comparison = comparison(Verdict::same)},
                      {.name = "broken", .comparison = comparison(Verdict::differs)}});
  EXPECT_LT(page.find("broken"), page.find(">fine"));
  EXPECT_THAT(page, HasSubstr("1 of 2 pass"));
}

TEST(GoldenReport, follows_light_and_dark) {
  const TestFolder folder;
  EXPECT_THAT(report(folder, {}), HasSubstr("prefers-color-scheme: dark"));
}

}  // namespace
}  // namespace collage
