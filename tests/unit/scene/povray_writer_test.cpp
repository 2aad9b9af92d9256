#include "scene/povray_writer.h"

#include <cstdlib>

#include <glm/gtc/constants.hpp>
#include <gmock/gmock.h>

#include "unit/scene/picture.h"
#include "unit/scene/support.h"

namespace collage {
namespace {

using testing::cube;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::parsed_ppm;
using testing::Picture;
using testing::RecordingStatus;
using testing::TemporaryFolder;
namespace fs = std::filesystem;

/// What scene.pov expects of templates/collage.inc, with flat colours, seen from +z: the picture is
/// 4 units wide and 3 high round the origin.
constexpr const char* flat_macros = R"(
#macro Plain_Paint(Color, Opacity) pigment { rgb Color } #end
#macro Picture_Paint(Image_Pigment, Opacity) pigment { uv_mapping Image_Pigment } #end
#macro As_In_File(Paint, Glow, Specular, Shininess)
  texture { pigment { Paint } finish { ambient 0 diffuse 0 emission 1 } }
#end
#macro As_In_File_Physically(Paint, Glow, Roughness, Metallic, Sheen, Coat)
  texture { pigment { rgb <Metallic, Sheen, Coat> } finish { ambient 0 diffuse 0 emission 1 } }
#end
#macro Felt(Paint, Glow)
  texture { pigment { rgb <0, 0, 1> } finish { ambient 0 diffuse 0 emission 1 } }
#end
#macro Set_Floor(Caster) #end
#declare Is_Shadow_Given = 0;
#declare Element_Interior = interior { ior 1.45 };
#declare Place_Sculpture = transform { scale 1 }
)";
constexpr const char* flat_template = R"(
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, 20> direction -z right 4 * x up 3 * y }
)";

/// A square from (-1, -1) to (1, 1) at z = 0 towards +z, of two triangles: below and above the
/// diagonal. The uv are 0 to 1.
Mesh square() {
  Mesh mesh;
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.uv_triangles = mesh.triangles;
  mesh.normals = {{0, 0, 1}};
  mesh.normal_triangles = {{0, 0, 0}, {0, 0, 0}};
  return mesh;
}

/// A PPM picture, red and green above, blue and white below.
std::string quarters() {
  std::string text = "P3\n16 16\n255\n";
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      text += y < 8 ? (x < 8 ? "255 0 0\n" : "0 255 0\n") : (x < 8 ? "0 0 255\n" : "255 255 255\n");
    }
  }
  return text;
}

class PovrayWriter : public ::testing::Test {
 protected:
  PovrayWriter() {
    folder.write("collage.inc", flat_macros);
    folder.write("flat.inc", flat_template);
  }

  std::string written(const Composition& composition) {
    write_povray(folder.path(), composition, "flat", status);
    return read_file(folder.path() / "scene.pov");
  }

  /// Renders scene.pov after the given declarations.
  Picture rendered(const std::string& declarations = "") {
    folder.write("job.pov", "#version 3.7;\n" + declarations + "#include \"scene.pov\"\n");
    const std::string command = "cd '" + folder.path().string() +
                                "' && povray +Ijob.pov +Opicture.ppm +FP +W64 +H48 -D -A "
                                "> povray.log 2>&1 < /dev/null";
    const int result = std::system(command.c_str());
    log = read_file(folder.path() / "povray.log");
    EXPECT_EQ(result, 0) << log;
    return parsed_ppm(read_file(folder.path() / "picture.ppm"));
  }

  TemporaryFolder folder;
  RecordingStatus status;
  std::string log;
};

TEST_F(PovrayWriter, PlacesInstancesAsTheirTransformsSay) {
  const Mesh mesh = cube();
  // Turned by 45 degrees about z, the cube's silhouette is a diamond.
  const std::vector<Instance> instances{
      {0, 0.5, glm::angleAxis(glm::pi<double>() / 4, dvec3(0, 0, 1)), {1, 0.5, 0}}};
  const Composition composition{"one",     "collage 0", {{"cube", mesh, "#ff0000"}},
                                instances, nullptr,     {{-1, -1, -1}, {1, 1, 1}}};
  written(composition);
  const Picture picture = rendered();
  EXPECT_THAT(log, Not(HasSubstr("rror")));
  EXPECT_THAT(log, Not(HasSubstr("egenerate")));
  EXPECT_EQ(picture.color_at(1.0, 0.5), "red");
  EXPECT_EQ(picture.color_at(1.0, 1.1), "red");
  EXPECT_EQ(picture.color_at(1.45, 0.95), "black");
  EXPECT_EQ(picture.color_at(-1.0, 0.5), "black");
}

TEST_F(PovrayWriter, ShowsStagesAndSingleElements) {
  const Mesh mesh = square();
  std::vector<Instance> instances;
  for (int i = 0; i < 10; ++i) {
    instances.push_back({static_cast<unsigned>(i % 2), 0.15, {1, 0, 0, 0}, {-1.8 + 0.4 * i, 0, 0}});
  }
  written({"row",
           "collage 0",
           {{"a", mesh, "#ff0000"}, {"b", mesh, "#00ff00"}},
           instances,
           nullptr,
           {}});
  const Picture all = rendered();
  EXPECT_EQ(all.color_at(-1.8, 0), "red");
  EXPECT_EQ(all.color_at(1.8, 0), "green");
  const Picture half = rendered("#declare Stage = 0.5;\n");
  EXPECT_EQ(half.color_at(-0.2, 0), "red");   // the fifth
  EXPECT_EQ(half.color_at(0.2, 0), "black");  // the sixth
  const Picture one = rendered("#declare Only_Element = 1;\n");
  EXPECT_EQ(one.color_at(-1.8, 0), "black");
  EXPECT_EQ(one.color_at(1.8, 0), "green");
  const Picture none = rendered("#declare Stage = 0;\n");
  EXPECT_EQ(none.color_at(-1.8, 0), "black");
}

TEST_F(PovrayWriter, ShowsPicturesTheRightWayUp) {
  Mesh mesh = square();
  Material picture;
  picture.texture = folder.write("in/quarters.ppm", quarters());
  Material plain;
  plain.color = {1, 1, 0};
  mesh.materials = {plain, picture};
  for (const auto& assignment :
       {std::vector<std::uint32_t>{1, 1}, std::vector<std::uint32_t>{0, 1}}) {
    mesh.triangle_materials = assignment;
    const std::vector<Instance> instances{{}};
    written({"picture", "collage 0", {{"square", mesh, ""}}, instances, nullptr, {}});
    const Picture shown = rendered();
    const bool all = assignment[0] == 1;
    EXPECT_EQ(shown.color_at(-0.8, 0.8), "red");
    EXPECT_EQ(shown.color_at(0.7, 0.9), "green");
    EXPECT_EQ(shown.color_at(-0.9, -0.7), "blue");
    EXPECT_EQ(shown.color_at(0.8, -0.8), all ? "white" : "yellow");
  }
  EXPECT_TRUE(fs::exists(folder.path() / "texture-0.ppm"));
  EXPECT_FALSE(fs::exists(folder.path() / "texture-1.ppm"));
}

TEST_F(PovrayWriter, ShowsTheTargetWhereTheTemplateWantsIt) {
  const Mesh mesh = square();
  const std::vector<Instance> instances{{0, 0.1, {1, 0, 0, 0}, {0, 0, 1}}};
  written(
      {"ghost", "collage 0", {{"a", mesh, "#ff0000"}}, instances, &mesh, {{-1, -1, 0}, {1, 1, 0}}});
  EXPECT_EQ(rendered().color_at(0.5, 0.5), "black");
  folder.write("flat.inc", std::string(flat_template) +
                               "object { Target pigment { rgb <0, 0, 1> }\n"
                               "         finish { ambient 0 diffuse 0 emission 1 } }\n");
  const Picture ghost = rendered();
  EXPECT_EQ(ghost.color_at(0.5, 0.5), "blue");
  EXPECT_EQ(ghost.color_at(0, 0), "red");
}

TEST_F(PovrayWriter, DeclaresBoxes) {
  const Mesh mesh = cube();
  const std::vector<Instance> instances{{0, 0.5, {1, 0, 0, 0}, {3, 0, 0}}};
  const std::string text = written({"one",
                                    "collage 0.1.0",
                                    {{"cube", mesh, ""}},
                                    instances,
                                    nullptr,
                                    {{-4, -5, -6}, {4, 5, 6}}});
  EXPECT_THAT(text,
              ::testing::StartsWith("// one: 1 instance of 1 element, made by collage 0.1.0.\n"));
  EXPECT_THAT(text, HasSubstr("#declare Sculpture_Min = <2.5, -0.5, -0.5>;\n"
                              "#declare Sculpture_Max = <3.5, 0.5, 0.5>;\n"));
  EXPECT_THAT(text, HasSubstr("#declare Target_Min = <-4, -5, -6>;\n"));
  EXPECT_THAT(text, HasSubstr("#declare Has_Target = 0;\n"));
  EXPECT_THAT(text, HasSubstr("\n#if (0 < Shown[0]) object { Element_0 matrix "
                              "<0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5, 3, 0, 0> } #end\n"));
}

TEST_F(PovrayWriter, FinishesAsTheSceneOrTheMaterialSays) {
  Mesh mesh = square();
  const std::vector<Instance> instances{{}};
  written({"felt", "collage 0", {{"a", mesh, "#ff0000", Finish::felt}}, instances, nullptr, {}});
  EXPECT_EQ(rendered().color_at(0, 0), "blue");
  Material material;
  material.roughness = 0.5;
  material.sheen = 1.0;
  mesh.materials = {material};
  written({"physical", "collage 0", {{"a", mesh, ""}}, instances, nullptr, {}});
  EXPECT_EQ(rendered().color_at(0, 0), "green");
}

TEST_F(PovrayWriter, SetsTheFloorUnderAllInstances) {
  const Mesh mesh = square();
  std::vector<Instance> instances;
  for (int i = 0; i < 100; ++i) {
    instances.push_back({0, 0.05, {1, 0, 0, 0}, {-1.8 + 0.4 * (i % 10), -1 + 0.2 * (i / 10), 0}});
  }
  written({"grid", "collage 0", {{"a", mesh, "#ff0000"}}, instances, nullptr, {}});
  folder.write("flat.inc", std::string(flat_template) + R"(
#macro Set_Floor(Caster)
  #local Normal = y;
  #local Hits = 0;
  #local K = 0;
  #while (K < 100)
    #local From = <-1.8 + 0.4 * mod(K, 10), -1 + 0.2 * floor(K / 10), 5>;
    #local Hit = trace(Caster, From, -z, Normal);
    #local Hits = Hits + (vlength(Normal) > 0);
    #local K = K + 1;
  #end
  #debug concat("hits ", str(Hits, 0, 0), "\n")
#end
)");
  rendered();
  EXPECT_THAT(log, HasSubstr("hits 100"));
  rendered("#declare Stage = 0.25;\n");
  EXPECT_THAT(log, HasSubstr("hits 25"));
}

TEST_F(PovrayWriter, ShowsPropsAtEachStageAndTheirShadow) {
  const Mesh mesh = cube();
  Mesh prop = square();
  prop.materials.emplace_back();
  prop.materials[0].color = {0, 1, 0};
  prop.triangle_materials = {0, 0};
  const std::vector<Instance> instances{{0, 0.25, {1, 0, 0, 0}, {-1.5, 0, 0}}};
  Composition composition{"bowl", "collage 0", {{"cube", mesh, "#ff0000"}}, instances, nullptr, {}};
  composition.props.push_back({"bowl", prop});
  written(composition);
  folder.write("flat.inc", std::string(flat_template) + R"(
#macro Set_Floor(Caster)
  #local Normal = y;
  #local Hit = trace(Caster, <0.5, 0.5, 5>, -z, Normal);
  #debug concat("shadow ", str((vlength(Normal) > 0), 0, 0), "\n")
#end
)");
  const Picture picture = rendered();
  EXPECT_EQ(picture.color_at(-1.5, 0), "red");
  EXPECT_EQ(picture.color_at(0, 0), "green");
  EXPECT_THAT(log, HasSubstr("shadow 1"));
  const Picture empty = rendered("#declare Stage = 0;\n");
  EXPECT_EQ(empty.color_at(-1.5, 0), "black");
  EXPECT_EQ(empty.color_at(0, 0), "green");
}

TEST_F(PovrayWriter, TakesNoCodeFromNames) {
  Mesh mesh = square();
  const std::string evil = "a\n#error \"owned\" */ \\";
  Material material;
  material.name = evil;
  material.texture = folder.write("in/\"; #error \"x\" \".ppm", "P3\n1 1\n255\n255 0 0\n");
  mesh.materials = {material};
  const std::vector<Instance> instances{{}};
  const std::string text = written({evil, evil, {{evil, mesh, ""}}, instances, &mesh, {}});
  EXPECT_THAT(text, Not(HasSubstr("#error")));
  EXPECT_EQ(rendered().color_at(0, 0), "red");
}

TEST_F(PovrayWriter, UsesTheColourWhereThePictureIsNone) {
  Mesh mesh = square();
  Material material;
  material.color = {0, 1, 0};
  material.texture = folder.write("in/notes.png", "not a picture");
  mesh.materials = {material};
  const std::vector<Instance> instances{{}};
  written({"x", "collage 0", {{"a", mesh, ""}}, instances, nullptr, {}});
  ASSERT_EQ(status.notes.size(), 1U);
  EXPECT_THAT(status.notes[0], HasSubstr("notes.png is not a picture that POV-Ray reads"));
  EXPECT_EQ(rendered().color_at(0, 0), "green");
}

TEST_F(PovrayWriter, SurvivesDegenerateMeshes) {
  Mesh mesh = square();
  mesh.positions.push_back(mesh.positions[0]);
  mesh.triangles.push_back({0, 4, 1});  // no area
  mesh.triangles.push_back({0, 1, 2});  // twice
  mesh.uv_triangles.resize(4, {0, 1, 2});
  mesh.normals.push_back({0, 0, 0});
  mesh.normal_triangles.resize(4, {0, 1, 0});
  const std::vector<Instance> instances{{0, 1e-3, {1, 0, 0, 0}, {0, 0, 0}}, {}};
  written({"x", "collage 0", {{"a", mesh, "#ff0000"}}, instances, &mesh, {}});
  EXPECT_EQ(rendered().color_at(0, 0), "red");
  EXPECT_THAT(log, Not(HasSubstr("Normal vector in mesh2 cannot be zero")));
}

TEST_F(PovrayWriter, WritesASculptureWithoutInstances) {
  const Mesh mesh = square();
  written({"none", "collage 0", {{"a", mesh, ""}}, {}, &mesh, {{-1, -1, 0}, {1, 1, 0}}});
  EXPECT_EQ(rendered().color_at(0, 0), "black");
}

}  // namespace
}  // namespace collage
