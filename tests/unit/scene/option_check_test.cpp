#include "scene/option_check.h"

#include <limits>

#include "scene/options_table.h"
#include "unit/scene/support.h"

namespace collage {
namespace {

using testing::error_of;

OptionValue check(const std::string& key, const OptionValue& value) {
  return checked(*find_option(key), 0, value, {});
}

TEST(OptionCheck, TurnsWholeNumbersIntoNumbersWhereThoseAreMeant) {
  EXPECT_EQ(check("packing.threshold", std::int64_t{1}), OptionValue(1.0));
  EXPECT_EQ(error_of([] { check("packing.seed", 1.0); }),
            "packing.seed = 1 is of the wrong type; use a whole number from 0 to "
            "9007199254740992");
}

TEST(OptionCheck, RefusesWhatIsNotFinite) {
  for (const double value :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_NE(error_of([&] { check("packing.threshold", value); }), "");
    EXPECT_NE(error_of([&] { check("element.scales", std::vector<double>{1, value}); }), "");
    EXPECT_NE(error_of([&] { check("render.size", std::vector<double>{64, value}); }), "");
  }
}

TEST(OptionCheck, TakesAnEmptyListForEitherKind) {
  EXPECT_EQ(check("render.stills", std::vector<double>{}), OptionValue(std::vector<std::string>{}));
  EXPECT_EQ(check("contact_sheet.stages", std::vector<double>{}),
            OptionValue(std::vector<double>{}));
  EXPECT_NE(error_of([] { check("element.scales", std::vector<double>{}); }), "");
}

TEST(OptionCheck, KnowsViewsAndColours) {
  for (const char* view : {"front", "0/0", "-360/90", "12.5/-3.25"}) {
    EXPECT_EQ(error_of([&] { check("render.stills", std::vector<std::string>{view}); }), "");
  }
  for (const char* view : {"", "fron", "0", "/", "0/91", "361/0", "nan/0", "0/0/0", "../x"}) {
    EXPECT_NE(error_of([&] { check("render.stills", std::vector<std::string>{view}); }), "")
        << view;
  }
  for (const char* color : {"", "#fff", "red", "#12345g", "#1234567"}) {
    EXPECT_NE(error_of([&] { check("element.color", std::string(color)); }), "") << color;
  }
}

TEST(OptionCheck, ResolvesPathsAgainstTheFolder) {
  const testing::TemporaryFolder folder;
  const auto mesh = folder.write("a/cup.obj", "");
  const OptionSource source{{}, folder.path() / "b"};
  const Option& option = *find_option("element.mesh");
  EXPECT_EQ(checked(option, 0, std::string("../a/cup.obj"), source), OptionValue(mesh.string()));
  EXPECT_EQ(checked(option, 0, mesh.string(), source), OptionValue(mesh.string()));
  EXPECT_NE(error_of([&] { checked(option, 0, std::string("cup.obj"), source); }), "");
  EXPECT_NE(error_of([&] { checked(option, 0, std::string(""), source); }), "");
  EXPECT_NE(error_of([&] { checked(option, 0, std::string("../a"), source); }), "");
  EXPECT_NE(error_of([&] { checked(option, 0, std::string("a\0b", 3), source); }), "");
}

TEST(OptionCheck, TakesTemplatesOfTheUser) {
  const testing::TemporaryFolder folder;
  const auto own = folder.write("my-look.inc", "");
  folder.write("my look.inc", "");
  const OptionSource source{{}, folder.path()};
  const Option& option = *find_option("render.template");
  EXPECT_EQ(checked(option, 0, std::string("my-look.inc"), source), OptionValue(own.string()));
  EXPECT_EQ(checked(option, 0, std::string("clay"), source), OptionValue(std::string("clay")));
  EXPECT_NE(error_of([&] { checked(option, 0, std::string("none.inc"), source); }), "");
  EXPECT_NE(error_of([&] { checked(option, 0, std::string("my look.inc"), source); }), "");
  EXPECT_EQ(error_of([&] { checked(option, 0, std::string("sudio"), source); }),
            "render.template = \"sudio\" is not available; use \"studio\", \"daylight\", \"clay\", "
            "\"x-ray\" or \"breakdown\", or the path of a template ending in .inc");
}

}  // namespace
}  // namespace collage
