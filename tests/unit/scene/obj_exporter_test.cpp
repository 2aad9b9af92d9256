#include "scene/obj_exporter.h"

#include <sstream>

#include <gmock/gmock.h>

#include "unit/scene/support.h"

namespace collage {
namespace {

using testing::cube;
using ::testing::HasSubstr;
using testing::RecordingStatus;
using testing::TemporaryFolder;

std::vector<dvec3> rows(const std::string& text, const std::string& keyword) {
  std::vector<dvec3> result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string word;
    dvec3 v;
    if (words >> word && word == keyword && words >> v.x >> v.y >> v.z) {
      result.push_back(v);
    }
  }
  return result;
}

Mesh triangle() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.normals = {{0, 0, 1}};
  mesh.normal_triangles = {{0, 0, 0}};
  mesh.uvs = {{0, 0}, {1, 0}};
  mesh.uv_triangles = {{0, 1, 1}};
  return mesh;
}

class ObjExporter : public ::testing::Test {
 protected:
  std::string exported(const Composition& composition) {
    export_obj(folder.path() / "all of it.obj", composition, status);
    return read_file(folder.path() / "all of it.obj");
  }

  TemporaryFolder folder;
  RecordingStatus status;
};

TEST_F(ObjExporter, WritesTransformedCopies) {
  const Mesh mesh = cube();
  const std::vector<Instance> instances{{0, 2.0, glm::normalize(glm::dquat(1, 2, 3, 4)), {5, 6, 7}},
                                        {}};
  const std::string text =
      exported({"x", "collage 0", {{"a cube", mesh, ""}}, instances, nullptr, {}});
  const std::vector<dvec3> positions = rows(text, "v");
  ASSERT_EQ(positions.size(), 16U);
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_EQ(positions[i], instances[i / 8].world_from_element(mesh.positions[i % 8]));
  }
  EXPECT_EQ(rows(text, "f").size(), 24U);
  EXPECT_EQ(rows(text, "f")[12], dvec3(9, 11, 12));
  EXPECT_THAT(text, HasSubstr("g a_cube.0\n"));
  EXPECT_THAT(text, HasSubstr("g a_cube.1\n"));
  EXPECT_THAT(text, HasSubstr("mtllib all_of_it.mtl\n"));
}

TEST_F(ObjExporter, KeepsNormalsAndUvs) {
  const Mesh mesh = triangle();
  const Mesh bare = cube();
  const std::vector<Instance> instances{{1, 1, {1, 0, 0, 0}, {0, 0, 0}},
                                        {0, 3, glm::angleAxis(1.0, dvec3(1, 0, 0)), {0, 0, 9}},
                                        {0, 1, {1, 0, 0, 0}, {0, 0, 0}}};
  const std::string text = exported(
      {"x", "collage 0", {{"t", mesh, ""}, {"cube", bare, "#ff0000"}}, instances, nullptr, {}});
  const auto normals = rows(text, "vn");
  ASSERT_EQ(normals.size(), 2U);
  EXPECT_EQ(normals[0], instances[1].rotation * dvec3(0, 0, 1));
  EXPECT_THAT(text, HasSubstr("f 9/1/1 10/2/1 11/2/1\n"));
  EXPECT_THAT(text, HasSubstr("f 12/1/2 13/2/2 14/2/2\n"));
}

TEST_F(ObjExporter, WritesMaterialsAndCopiesPictures) {
  Mesh mesh = triangle();
  mesh.triangles.push_back({0, 1, 2});
  mesh.normal_triangles.push_back({0, 0, 0});
  mesh.uv_triangles.push_back({0, 1, 1});
  Material first;
  first.color = {0.25, 0.5, 1};
  Material second;
  second.texture = folder.write("in/wood grain.ppm", "P3 1 1 255 1 2 3");
  mesh.materials = {first, second};
  mesh.triangle_materials = {1, 0};
  const std::vector<Instance> instances{{}};
  const std::string text = exported({"x", "collage 0", {{"t", mesh, ""}}, instances, nullptr, {}});
  const std::string materials = read_file(folder.path() / "all_of_it.mtl");
  EXPECT_THAT(materials,
              HasSubstr("newmtl element-0-material-0\nKd 0.537098730483 0.735356983052 1\n"));
  EXPECT_THAT(materials, HasSubstr("map_Kd texture-0.ppm\n"));
  EXPECT_EQ(read_file(folder.path() / "texture-0.ppm"), "P3 1 1 255 1 2 3");
  EXPECT_LT(text.find("usemtl element-0-material-1\n"), text.find("usemtl element-0-material-0\n"));
}

TEST_F(ObjExporter, LeavesNothingHalfWrittenWhenStopped) {
  const Mesh mesh = cube();
  const std::vector<Instance> instances{{}};
  status.stop = true;
  EXPECT_THROW(exported({"x", "collage 0", {{"c", mesh, ""}}, instances, nullptr, {}}),
               Interrupted);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "all of it.obj"));
}

}  // namespace
}  // namespace collage
