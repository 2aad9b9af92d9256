#include "scene/set_option.h"

#include "unit/scene/support.h"

namespace collage {
namespace {

using testing::error_of;

Scene scene_of_two() {
  Scene scene;
  scene.elements.resize(2);
  return scene;
}

std::string error(const std::string& assignment) {
  return error_of([&] {
    Scene scene = scene_of_two();
    set_option(scene, assignment);
  });
}

TEST(SetOption, SetsEveryKindOfValue) {
  Scene scene = scene_of_two();
  for (const char* assignment :
       {"packing.threshold=0.01", "packing.seed = 7", "packing.scaling=to-hole", "render.exr=true",
        "render.size=640,480", "render.stills=front, 30/15", "element.1.color=#c8102e",
        "element.0.scales=[1, 0.5]", "render.template=\"clay\""}) {
    set_option(scene, assignment);
  }
  EXPECT_EQ(scene.packing.threshold, 0.01);
  EXPECT_EQ(scene.packing.seed, 7U);
  EXPECT_EQ(scene.packing.scaling, Scaling::to_hole);
  EXPECT_TRUE(scene.render.exr);
  EXPECT_EQ(scene.render.size, (std::array<int, 2>{640, 480}));
  EXPECT_EQ(scene.render.stills, (std::vector<std::string>{"front", "30/15"}));
  EXPECT_EQ(scene.elements[0].color, "");
  EXPECT_EQ(scene.elements[1].color, "#c8102e");
  EXPECT_EQ(scene.elements[0].scales, (std::vector<double>{1, 0.5}));
  EXPECT_EQ(scene.render.look, "clay");
  set_option(scene, "render.stills=[]");
  EXPECT_TRUE(scene.render.stills.empty());
}

TEST(SetOption, ReplacesTheTarget) {
  const testing::TemporaryFolder folder;
  Scene scene = scene_of_two();
  scene.target.mesh = "body.obj";
  const auto grid = folder.write("grid.sdf", "");
  set_option(scene, "target.sdf=" + grid.string());
  EXPECT_EQ(scene.target.sdf, grid);
  EXPECT_TRUE(scene.target.mesh.empty());
  set_option(scene, "target.text.string=Cä");
  EXPECT_EQ(scene.target.text.string, "Cä");
  EXPECT_TRUE(scene.target.sdf.empty());
  set_option(scene, "target.mesh=" + grid.string());
  EXPECT_EQ(scene.target.text.string, "");
}

TEST(SetOption, ReplacesAnElement) {
  const testing::TemporaryFolder folder;
  Scene scene = scene_of_two();
  scene.elements[1].mesh = "cup.obj";
  set_option(scene, "element.1.text.string=e");
  set_option(scene, "element.1.text.depth=0.25");
  EXPECT_EQ(scene.elements[1].text.string, "e");
  EXPECT_EQ(scene.elements[1].text.depth, 0.25);
  EXPECT_TRUE(scene.elements[1].mesh.empty());
  set_option(scene, "element.1.mesh=" + folder.write("cup.obj", "").string());
  EXPECT_EQ(scene.elements[1].text.string, "");
}

TEST(SetOption, SaysWhatIsWrong) {
  EXPECT_EQ(error("packing.threshold=0"),
            "packing.threshold = 0 is out of range; use a number from 0.0001 to 1, a fraction of "
            "the target's longest side");
  EXPECT_EQ(error("packing.threshold=small"),
            "packing.threshold = \"small\" is of the wrong type; use a number from 0.0001 to 1, a "
            "fraction of the target's longest side");
  EXPECT_EQ(error("packing.treshold=1"),
            "there is no option 'packing.treshold'; did you mean 'packing.threshold'?");
  EXPECT_EQ(error("x=1"),
            "there is no option 'x'; write --set section.key=value, as in --set "
            "packing.threshold=0.01");
  EXPECT_EQ(error("packing.threshold"),
            "'packing.threshold' sets nothing; write section.key=value, as in "
            "packing.threshold=0.01");
  EXPECT_EQ(error("element.2.color=#ffffff"),
            "'element.2.color' does not name an element of the scene; write element.0. for the "
            "first, up to element.1. for the last");
  EXPECT_EQ(error("element.color=#ffffff"),
            "'element.color' does not name an element of the scene; write element.0. for the "
            "first, up to element.1. for the last");
  EXPECT_EQ(error("render.size=640"),
            "render.size = [640] is not a width and a height; use a list of two whole numbers "
            "from 16 to 16384, width and height in pixels");
  EXPECT_EQ(
      error("element.0.scales="),
      "element.0.scales = [] has too few entries; use a list of numbers from 0.000001 to 1000000, "
      "factors of the mesh's own size");
  EXPECT_EQ(error("render.stills=sideways"),
            "render.stills = [\"sideways\"] is not available; use a list of \"front\", "
            "\"three-quarter\", \"right\", \"back\", \"left\" or \"top\", or "
            "\"azimuth/elevation\" in degrees");
}

}  // namespace
}  // namespace collage
