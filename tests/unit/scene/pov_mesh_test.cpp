#include "scene/pov_mesh.h"

#include "unit/scene/support.h"

namespace collage {
namespace {

std::string written(const Mesh& mesh, const MeshTextures& look) {
  const testing::TemporaryFolder folder;
  FileWriter file(folder.path() / "mesh.inc");
  append_mesh2(file, "Thing", mesh, look);
  file.commit();
  return read_file(folder.path() / "mesh.inc");
}

Mesh triangle() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0.1, 0}};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

TEST(PovMesh, WritesVerticesAndFaces) {
  EXPECT_EQ(written(triangle(), {}),
            "#declare Thing = mesh2 {\n"
            "  vertex_vectors {\n    3,\n    <0, 0, 0>,\n    <1, 0, 0>,\n    <0, 0.1, 0>\n  }\n"
            "  face_indices {\n    1,\n    <0,1,2>\n  }\n"
            "}\n");
}

TEST(PovMesh, WritesNormalsUvsAndTextures) {
  Mesh mesh = triangle();
  mesh.normals = {{0, 0, 1}, {0, 0, 0}};
  mesh.normal_triangles = {{0, 0, 1}};
  mesh.uvs = {{0.5, 2}};
  mesh.uv_triangles = {{0, 0, 0}};
  mesh.triangle_materials = {1};
  const std::string lists =
      "  normal_vectors {\n    2,\n    <0, 0, 1>,\n    <0, 1, 0>\n  }\n"
      "  uv_vectors {\n    1,\n    <0.5, 2>\n  }\n";
  const std::string indices =
      "  normal_indices {\n    1,\n    <0,0,1>\n  }\n"
      "  uv_indices {\n    1,\n    <0,0,0>\n  }\n";
  const std::string all_the_first =
      written(mesh, {{"A", "B"}, ElementLook::Assignment::all_the_first, true});
  EXPECT_NE(all_the_first.find(lists + "  face_indices {\n    1,\n    <0,1,2>\n  }\n" + indices +
                               "  texture { A }\n}\n"),
            std::string::npos);
  const std::string by_triangle =
      written(mesh, {{"A", "B"}, ElementLook::Assignment::by_triangle, true});
  EXPECT_NE(
      by_triangle.find(lists +
                       "  texture_list {\n    2,\n    texture { A },\n    texture { B }\n  }\n"
                       "  face_indices {\n    1,\n    <0,1,2>,1\n  }\n" +
                       indices + "}\n"),
      std::string::npos);
  const std::string without_pictures = written(mesh, {{"A"}});
  EXPECT_EQ(without_pictures.find("uv_"), std::string::npos);
}

}  // namespace
}  // namespace collage
