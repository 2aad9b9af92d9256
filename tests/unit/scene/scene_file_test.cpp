#include "scene/scene_file.h"

#include <gmock/gmock.h>

#include "unit/scene/support.h"

namespace collage {
namespace {

using testing::error_of;
using testing::TemporaryFolder;
namespace fs = std::filesystem;

constexpr const char* minimal = R"([target]
mesh = "body.obj"
[[element]]
mesh = "cup.obj"
)";

class SceneFile : public ::testing::Test {
 protected:
  SceneFile() {
    folder.write("body.obj", "");
    folder.write("cup.obj", "");
  }

  Scene read(const std::string& text) const { return read_scene(folder.write("scene.toml", text)); }

  /// The error of reading `text`, without the folder in front.
  std::string error(const std::string& text) const {
    const std::string message = error_of([&] { read(text); });
    const std::string start = folder.path().string() + "/";
    return message.starts_with(start) ? message.substr(start.size()) : message;
  }

  TemporaryFolder folder;
};

TEST_F(SceneFile, FillsInDefaults) {
  const Scene scene = read(minimal);
  EXPECT_EQ(scene.target.mesh, folder.path() / "body.obj");
  EXPECT_EQ(scene.target.resolution, 100);
  EXPECT_EQ(scene.elements.at(0).mesh, folder.path() / "cup.obj");
  EXPECT_EQ(scene.elements.at(0).scales, std::vector<double>{1.0});
  EXPECT_EQ(scene.packing.threshold, PackingOptions{}.threshold);
}

TEST_F(SceneFile, ReadsAllKindsOfValues) {
  const Scene scene = read(R"(
[target]
mesh = "body.obj"
resolution = 64
jitter = 1
repair = "none"
[[element]]
mesh = "cup.obj"
scales = [1, 0.5]
color = "#c8102e"
[[element]]
mesh = "cup.obj"
weight = 2.5
[packing]
scaling = "to-hole"
choose = "weighted"
distance = "vertices"
seed = 9007199254740992
[render]
template = "x-ray"
size = [640, 480]
stills = ["front", "-30/12.5"]
exr = true
[turntable]
frames = 36
elevation = -10
[contact_sheet]
stages = [0.02, 0.2, 1]
)");
  EXPECT_EQ(scene.target.resolution, 64);
  EXPECT_EQ(scene.target.jitter, 1.0);
  EXPECT_EQ(scene.target.repair, Repair::none);
  EXPECT_EQ(scene.elements.at(0).repair, Repair::full);
  EXPECT_EQ(scene.elements.at(0).scales, (std::vector<double>{1, 0.5}));
  EXPECT_EQ(scene.elements.at(0).color, "#c8102e");
  EXPECT_EQ(scene.elements.at(1).weight, 2.5);
  EXPECT_EQ(scene.packing.scaling, Scaling::to_hole);
  EXPECT_EQ(scene.packing.choose, Choose::weighted);
  EXPECT_EQ(scene.packing.distance, Distance::vertices);
  EXPECT_EQ(scene.packing.seed, 9007199254740992U);
  EXPECT_EQ(scene.render.look, "x-ray");
  EXPECT_EQ(scene.render.size, (std::array<int, 2>{640, 480}));
  EXPECT_EQ(scene.render.stills, (std::vector<std::string>{"front", "-30/12.5"}));
  EXPECT_TRUE(scene.render.exr);
  EXPECT_EQ(scene.turntable.frames, 36);
  EXPECT_EQ(scene.turntable.elevation_degrees, -10.0);
  EXPECT_EQ(scene.contact_sheet.stages, (std::vector<double>{0.02, 0.2, 1}));
}

TEST_F(SceneFile, IsCalledAsItsFolderOrAsTheFile) {
  folder.write("teapot/scene.toml",
               "[target]\nmesh='../body.obj'\n[[element]]\nmesh='../cup.obj'\n");
  folder.write("teapot/other.toml",
               "[target]\nmesh='../body.obj'\n[[element]]\nmesh='../cup.obj'\n");
  EXPECT_EQ(read_scene(folder.path() / "teapot").name, "teapot");
  EXPECT_EQ(read_scene(folder.path() / "teapot/").name, "teapot");
  EXPECT_EQ(read_scene(folder.path() / "teapot/scene.toml").name, "teapot");
  EXPECT_EQ(read_scene(folder.path() / "teapot/other.toml").name, "other");
  EXPECT_EQ(read_scene(folder.path() / "teapot").target.mesh, folder.path() / "body.obj");
}

TEST_F(SceneFile, NamesWhatIsUnknown) {
  const std::string text = minimal;
  EXPECT_EQ(error(text + "[packing]\ntreshold = 0.1\n"),
            "scene.toml:6: there is no key 'treshold' in [packing]; did you mean 'threshold'?");
  EXPECT_EQ(error(text + "[paking]\n"),
            "scene.toml:5: there is no section [paking]; did you mean 'packing'?");
  EXPECT_EQ(error(text + "[turntable]\nzzzzzzzz = 1\n"),
            "scene.toml:6: there is no key 'zzzzzzzz' in [turntable]; use one of frames, size, "
            "quality, elevation, fps");
  EXPECT_EQ(error(text + "[packing]\n\"seed.x\" = 1\n"),
            "scene.toml:6: there is no key 'seed.x' in [packing]; did you mean 'seed'?");
}

TEST_F(SceneFile, NamesWhatIsOutOfRange) {
  const std::string text = std::string(minimal) + "[packing]\n";
  const std::string remedy =
      " is out of range; use a number from 0.0001 to 1, a fraction of the target's longest side";
  EXPECT_EQ(error(text + "threshold = 0\n"), "scene.toml:6: packing.threshold = 0" + remedy);
  EXPECT_EQ(error(text + "threshold = nan\n"), "scene.toml:6: packing.threshold = nan" + remedy);
  EXPECT_EQ(error(text + "threshold = -inf\n"), "scene.toml:6: packing.threshold = -inf" + remedy);
  EXPECT_EQ(error(text + "seed = -1\n"),
            "scene.toml:6: packing.seed = -1 is out of range; use a whole number from 0 to "
            "9007199254740992");
}

TEST_F(SceneFile, NamesWhatIsOfTheWrongType) {
  const std::string text = std::string(minimal) + "[packing]\n";
  EXPECT_EQ(error(text + "seed = 1.5\n"),
            "scene.toml:6: packing.seed = 1.5 is of the wrong type; use a whole number from 0 to "
            "9007199254740992");
  EXPECT_EQ(error(text + "scaling = true\n"),
            "scene.toml:6: packing.scaling = true is of the wrong type; use \"fixed\" or "
            "\"to-hole\"");
  EXPECT_EQ(error(text + "scaling = 2020-01-01\n"),
            "scene.toml:6: packing.scaling is of the wrong type; use \"fixed\" or \"to-hole\"");
  EXPECT_EQ(error(text + "fit = \"cube\"\n"),
            "scene.toml:6: packing.fit = \"cube\" is not available; use \"sphere\" or \"shape\"");
  EXPECT_EQ(error("packing = 3\n"), "scene.toml:1: 'packing' is a section; write [packing]");
  EXPECT_EQ(error("[element]\nmesh = 'cup.obj'\n"),
            "scene.toml:1: 'element' is a list of sections; write [[element]]");
  EXPECT_EQ(error("element = [1]\n"),
            "scene.toml:1: 'element' is a list of sections; write [[element]]");
}

TEST_F(SceneFile, NamesWhatIsMissing) {
  EXPECT_EQ(error("[[element]]\nmesh = 'cup.obj'\n"),
            "scene.toml: has no target; add [target] with mesh = \"shape.obj\"");
  EXPECT_EQ(error("[target]\nresolution = 10\n"),
            "scene.toml:1: [target] has no shape; add mesh = \"shape.obj\"");
  EXPECT_EQ(error("[target]\nmesh = 'body.obj'\nsdf = 'cup.obj'\n"),
            "scene.toml:3: [target] has both mesh and sdf; keep one of them");
  EXPECT_EQ(error("[target]\nmesh = 'body.obj'\n"),
            "scene.toml: has no element; add [[element]] with mesh = \"shape.obj\"");
  EXPECT_EQ(error("[target]\nmesh = 'body.obj'\n[[element]]\nweight = 1\n"),
            "scene.toml:3: this [[element]] has no shape; add mesh = \"shape.obj\"");
}

TEST_F(SceneFile, ReadsLetters) {
  folder.write("own.otf", "");
  const Scene scene = read(R"([target]
text = { string = "Cä", font = "DejaVu Serif:bold", depth = 1, bevel = 0.03 }
[[element]]
text.string = "C"
[[element]]
[element.text]
string = "O"
font = "own.otf"
)");
  EXPECT_EQ(scene.target.text.string, "Cä");
  EXPECT_EQ(scene.target.text.font, "DejaVu Serif:bold");
  EXPECT_EQ(scene.target.text.depth, 1.0);
  EXPECT_EQ(scene.target.text.bevel, 0.03);
  EXPECT_TRUE(scene.target.mesh.empty());
  EXPECT_EQ(scene.elements.at(0).text.string, "C");
  EXPECT_EQ(scene.elements.at(0).text.font, LetterOptions{}.font);
  EXPECT_EQ(scene.elements.at(0).name(), "C");
  EXPECT_EQ(scene.elements.at(1).text.font, (folder.path() / "own.otf").string());
}

TEST_F(SceneFile, NamesWhatIsWrongWithLetters) {
  const auto target = [&](const std::string& lines) {
    return error("[target]\n" + lines + "\n[[element]]\nmesh = 'cup.obj'\n");
  };
  EXPECT_EQ(target("text = 'C'"), "scene.toml:2: 'text' is a table; write text = { string = … }");
  EXPECT_EQ(target("text = { strng = 'C' }"),
            "scene.toml:2: there is no key 'strng' in [target.text]; did you mean 'string'?");
  EXPECT_EQ(target("text = { xyzzyxyzzy = 'C' }"),
            "scene.toml:2: there is no key 'xyzzyxyzzy' in [target.text]; use one of string, "
            "font, depth, bevel");
  EXPECT_EQ(target("txt = 'C'"),
            "scene.toml:2: there is no key 'txt' in [target]; did you mean 'text'?");
  EXPECT_EQ(target("text = { font = 'DejaVu Sans' }"),
            "scene.toml:2: [target] has a text without letters; write text = { string = \"A\" }");
  EXPECT_EQ(target("text = { string = '' }"),
            "scene.toml:2: target.text.string = \"\" is empty; use one or more characters");
  EXPECT_EQ(target("text = { string = 'C', depth = 0 }"),
            "scene.toml:2: target.text.depth = 0 is out of range; use a number from 0.01 to 10, a "
            "fraction of a capital letter's height");
  EXPECT_EQ(target("mesh = 'body.obj'\ntext = { string = 'C' }"),
            "scene.toml:3: [target] has both mesh and text; keep one of them");
  EXPECT_EQ(target("text = { string = 'C', font = 'no.ttf' }"),
            "scene.toml:2: target.text.font: there is no file " +
                (folder.path() / "no.ttf").string() +
                "; check the path; it starts from the scene's folder unless it begins with /");
  EXPECT_EQ(error(std::string(minimal) + "text = { string = 'C' }\n"),
            "scene.toml:5: this [[element]] has both mesh and text; keep one of them");
}

TEST_F(SceneFile, NamesTheFileThatIsNotThere) {
  EXPECT_EQ(error("[target]\nmesh = 'no.obj'\n"),
            "scene.toml:2: target.mesh: there is no file " + (folder.path() / "no.obj").string() +
                "; check the path; it starts from the scene's folder unless it begins with /");
  EXPECT_EQ(error(std::string(minimal) + "color = 'red'\n"),
            "scene.toml:5: element.0.color = \"red\" is not a colour; use a colour as \"#rrggbb\", "
            "in sRGB");
}

TEST_F(SceneFile, NamesTheLineThatIsNotToml) {
  EXPECT_THAT(error("[target]\nmesh = \n"), ::testing::StartsWith("scene.toml:2: "));
  EXPECT_THAT(error("[packing]\nseed = 1\nseed = 2\n"),
              ::testing::StartsWith("scene.toml:3: Error while parsing key-value pair: cannot "
                                    "redefine existing integer 'seed'"));
  EXPECT_THAT(error("a = \"\xff\"\n"), ::testing::StartsWith("scene.toml:1: "));
}

TEST_F(SceneFile, RefusesWhatWouldExhaustTheStackOrMemory) {
  EXPECT_THAT(error("a = " + std::string(100000, '[')),
              ::testing::HasSubstr("scene.toml:1: Error while parsing value: exceeded maximum"));
  std::string dots = "a";
  for (int i = 0; i < 300000; ++i) {
    dots += ".a";
  }
  EXPECT_EQ(error(dots + " = 1\n"),
            "scene.toml: has more than 10000 dots, too many for a scene; check that it is a scene "
            "file");
  EXPECT_EQ(error(std::string((1 << 20) + 1, '#')),
            "scene.toml: is larger than the limit of 1 MiB; use a smaller file");
  EXPECT_EQ(error_of([] { read_scene("no-such-scene.toml"); }),
            "no-such-scene.toml: no such file; check the path");
}

}  // namespace
}  // namespace collage
