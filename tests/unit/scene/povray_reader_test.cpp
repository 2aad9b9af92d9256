#include "scene/povray_reader.h"

#include <gmock/gmock.h>

#include "scene/povray_writer.h"
#include "unit/scene/support.h"

namespace collage {
namespace {

using testing::cube;
using ::testing::HasSubstr;

class PovrayReader : public ::testing::Test {
 protected:
  PovrayReader() {
    instances_[1].element = 1;
    instances_[1].scale = 0.1;
    instances_[1].rotation = glm::angleAxis(0.3, glm::normalize(dvec3(1, -2, 3)));
    instances_[1].translation = dvec3(1.0 / 3.0, -1e-7, 12345.678);
    painted_.materials.resize(2);
    painted_.triangle_materials.assign(painted_.triangles.size(), 1);
    Composition composition;
    composition.elements.push_back({"plain", plain_, "#ffffff", Finish::automatic});
    composition.elements.push_back({"painted", painted_, "", Finish::automatic});
    composition.instances = instances_;
    composition.target = &target_;
    Status status;
    write_povray(folder_.path(), composition, "studio", status);
    text_ = read_file(folder_.path() / "scene.pov");
  }

  PovrayScene read() { return read_povray(folder_.path() / "scene.pov"); }

  /// What is said of the file where the first `from` reads `to`.
  std::string complaint(const std::string& from, const std::string& to) {
    std::string edited = text_;
    const std::size_t at = edited.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    folder_.write("scene.pov", edited.replace(at, from.size(), to));
    return testing::error_of([&] { read(); });
  }

  testing::TemporaryFolder folder_;
  Mesh plain_ = cube();
  Mesh painted_ = cube();
  Mesh target_ = cube();
  std::vector<Instance> instances_{2};
  std::string text_;
};

TEST_F(PovrayReader, ReadsWhatTheWriterWrote) {
  const PovrayScene scene = read();
  ASSERT_EQ(scene.meshes.size(), 3U);
  for (const char* name : {"Target", "Element_0", "Element_1"}) {
    EXPECT_EQ(scene.meshes.at(name).positions, cube().positions);
    EXPECT_EQ(scene.meshes.at(name).triangles, cube().triangles);
  }
  ASSERT_EQ(scene.instances.size(), 2U);
  EXPECT_EQ(scene.instances[0].matrix,
            (std::array<double, 12>{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}));
  EXPECT_EQ(scene.instances[1].element, 1U);
  EXPECT_EQ(scene.instances[1].matrix[9], 1.0 / 3.0);
}

TEST_F(PovrayReader, NamesTheLineThatItDoesNotKnow) {
  EXPECT_THAT(complaint("object { Element_1 matrix", "object { Element_1 scale 2 matrix"),
              HasSubstr("is not as the program writes it"));
  EXPECT_THAT(complaint("union {\n", "union {\n  sphere { 0, 1 }\n"), HasSubstr("scene.pov:"));
  EXPECT_THAT(complaint("    8,\n", "    9,\n"), HasSubstr("scene.pov:"));
  EXPECT_THAT(complaint("    8,\n", "    99999999999,\n"), HasSubstr("scene.pov:"));
  EXPECT_THAT(complaint("<0,2,3>", "<0,2>"), HasSubstr("scene.pov:"));
  EXPECT_THAT(complaint(text_.substr(text_.find("object {")), ""), HasSubstr("scene.pov:"));
}

}  // namespace
}  // namespace collage
