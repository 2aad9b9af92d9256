#include "render/shot.h"

#include "unit/render/support.h"

namespace collage {
namespace {

using ::testing::Contains;
using testing::error_of;
using ::testing::HasSubstr;
using testing::TestFolder;

TEST(View, named_ones_look_from_their_side) {
  EXPECT_EQ(parse_view("front").azimuth_degrees, 0.0);
  EXPECT_EQ(parse_view("right").azimuth_degrees, 90.0);
  EXPECT_EQ(parse_view("left").azimuth_degrees, -90.0);
  EXPECT_EQ(parse_view("back").azimuth_degrees, 180.0);
  EXPECT_GT(parse_view("top").elevation_degrees, 80.0);
  EXPECT_GT(parse_view("three-quarter").azimuth_degrees, 0.0);
}

TEST(View, angles_are_azimuth_and_elevation) {
  const View view = parse_view("-30.5/15");
  EXPECT_EQ(view.azimuth_degrees, -30.5);
  EXPECT_EQ(view.elevation_degrees, 15.0);
  EXPECT_EQ(file_stem(view), "-30.5_15");
}

TEST(View, unknown_ones_get_a_guess) {
  EXPECT_EQ(error_of([] { parse_view("frnt"); }), "there is no view 'frnt'; did you mean 'front'?");
  for (const char* text : {"30/", "/", "30/91", "nan/0", "1e99/0", "30/15/2", "", "somewhere"}) {
    EXPECT_THAT(error_of([&] { parse_view(text); }), HasSubstr("there is no view")) << text;
  }
  EXPECT_THAT(error_of([] { parse_view("30/91"); }), HasSubstr("elevation -90 to 90"));
}

TEST(Quality, is_read_by_name) {
  EXPECT_EQ(parse_quality("draft"), Quality::draft);
  EXPECT_EQ(parse_quality("fine"), Quality::fine);
  EXPECT_EQ(error_of([] { parse_quality("drafty"); }),
            "there is no quality 'drafty'; did you mean 'draft'?");
}

TEST(Shot, job_declares_everything_it_chooses) {
  Shot shot;
  shot.view = {"30/15.5", 30, 15.5};
  shot.look = "clay";
  shot.stage = 0.2;
  shot.only_element = 1;
  EXPECT_EQ(job_text(shot),
            "#version 3.7;\n#declare Azimuth = 30;\n#declare Elevation = 15.5;\n"
            "#declare Quality = 0;\n#declare Stage = 0.2;\n#declare Only_Element = 1;\n"
            "#declare All_Round = 0;\n"
            "#declare Template = \"clay.inc\";\n#include \"scene.pov\"\n");
  shot.only_element.reset();
  EXPECT_THAT(job_text(shot), HasSubstr("Only_Element = -1;"));
  shot.framing = Shot::Framing::all_round;
  EXPECT_THAT(job_text(shot), HasSubstr("All_Round = 1;"));
}

TEST(Shot, jitter_is_always_off) {
  for (const Quality quality : {Quality::draft, Quality::standard, Quality::fine}) {
    Shot shot;
    shot.quality = quality;
    EXPECT_THAT(povray_options(shot), Contains("-J"));
    EXPECT_THAT(povray_options(shot), Contains("+FN"));
    shot.format = PictureFormat::exr;
    EXPECT_THAT(povray_options(shot), Contains("+FE"));
  }
}

TEST(Shot, is_checked_before_anything_runs) {
  const TestFolder folder;
  for (const char* name :
       {"studio.inc", "clay.inc", "collage.inc", "collage-floor.inc", "a\"b.inc"}) {
    write_file(folder / name, "");
  }
  const auto error = [&](const auto& change) {
    Shot shot;
    change(shot);
    return error_of([&] { check_shot(shot, folder.path()); });
  };
  const std::string place = folder.path().string();
  EXPECT_EQ(error([](Shot&) {}), "no error");
  EXPECT_EQ(error([](Shot& shot) { shot.look = "studo"; }),
            place + ": there is no template 'studo'; did you mean 'studio'?");
  EXPECT_THAT(error([](Shot& shot) { shot.look = "a\"b"; }), HasSubstr("there is no template"));
  EXPECT_THAT(error([](Shot& shot) { shot.look = "collage"; }), HasSubstr("there is no template"));
  EXPECT_THAT(error([](Shot& shot) { shot.look = "collage-floor"; }),
              HasSubstr("there is no template"));
  EXPECT_THAT(error([](Shot& shot) { shot.width = 0; }),
              HasSubstr("0 x 960 pixels cannot be made"));
  EXPECT_THAT(error([](Shot& shot) { shot.stage = 0; }), HasSubstr("share of the instances"));
  EXPECT_THAT(error([](Shot& shot) { shot.stage = 1.5; }), HasSubstr("share of the instances"));
  EXPECT_THAT(error([](Shot& shot) { shot.only_element = -2; }), HasSubstr("no element -2"));
}

}  // namespace
}  // namespace collage
