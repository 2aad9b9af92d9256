#include "geometry/mesh_file.h"

#include <cmath>
#include <fstream>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "base/error.h"
#include "base/file.h"
#include "geometry/color.h"
#include "geometry/models.h"
#include "test_meshes.h"

namespace collage {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct Notes : Status {
  void note(std::string_view line) override { lines.emplace_back(line); }
  std::vector<std::string> lines;
};

/// A fresh folder, which stays where a test failed.
class MeshFileTest : public testing::Test {
 protected:
  MeshFileTest() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ =
        fs::temp_directory_path() / ("collage-" + std::to_string(::getpid()) + "-" + info->name());
    fs::create_directories(folder_);
  }
  ~MeshFileTest() override {
    if (!HasFailure()) {
      fs::remove_all(folder_);
    }
  }

  MeshFile read(std::string_view text) { return read(text, notes_); }
  MeshFile read(std::string_view text, Status& status) {
    write_file(folder_ / "m.obj", text);
    return read_obj(folder_ / "m.obj", status);
  }
  /// The error's text behind the folder's name.
  std::string error_of(std::string_view text) {
    try {
      read(text);
    } catch (const Error& error) {
      return std::string(error.what()).substr(folder_.string().size() + 1);
    }
    return "no error";
  }

  fs::path folder_;
  Notes notes_;
};

constexpr std::string_view square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST_F(MeshFileTest, ReadsEveryWayToNameACorner) {
  const std::string head = std::string(square) + "vt 0 0\nvt 1 1\nvn 0 0 2\n";
  for (const std::string face :
       {"f 1 2 3 4", "f 1/1 2/2 3/1 4/2", "f 1//1 2//1 3//1 4//1", "f 1/1/1 2/2/1 3/1/1 4/2/1",
        "f -4 -3 -2 -1", "f -4/-2/-1 -3/-1/-1 -2/-2/-1 -1/-1/-1", "f\t1 2  3 4 # remark",
        "f 1 2 \\\n 3 4", "f 1/ 2/ 3// 4/ "}) {
    const Mesh mesh = read(head + face).mesh;
    EXPECT_EQ(mesh.triangles.size(), 2U) << face;
    EXPECT_DOUBLE_EQ(surface_area(mesh), 1.0) << face;
    const bool has_uv = face.find("/1") == face.find('/') || face.find("/-2") != face.npos;
    EXPECT_EQ(mesh.uvs.size(), has_uv && face.find('/') != face.npos ? 2U : 0U) << face;
    if (!mesh.normals.empty()) {
      EXPECT_THAT(mesh.normals, ElementsAre(dvec3(0, 0, 1))) << face;
    }
  }
  EXPECT_THAT(notes_.lines, IsEmpty());
}

TEST_F(MeshFileTest, ReadsAllLineEndsAndAByteOrderMark) {
  const std::string lines = std::string(square) + "f 1 2 3\nf 1 3 4";
  for (const std::string_view end : {"\n", "\r\n", "\r"}) {
    std::string text = "\xef\xbb\xbf";
    for (const char c : lines) {
      text += c == '\n' ? std::string(end) : std::string(1, c);
    }
    EXPECT_EQ(read(text).mesh.triangles.size(), 2U);
  }
}

TEST_F(MeshFileTest, MergesGroupsAndDropsUnusedVertices) {
  const Mesh mesh =
      read(
          "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 1 1 0\no first\ng a b\ns 1\nf 2 3 4\n"
          "v nan 0 0\nv 0 1 0\no second one\ncurv 0 1 2\nl 1 2\np 3\nvp 1 2\nf 2 4 6\n")
          .mesh;
  EXPECT_EQ(mesh.positions.size(), 4U);
  EXPECT_EQ(mesh.triangles.size(), 2U);
  EXPECT_EQ(bounding_box(mesh).max, dvec3(1, 1, 0));
}

TEST_F(MeshFileTest, ReadsNumbersExactly) {
  const Mesh mesh =
      read("v +0.1 1e-3 -.5\nv 0.3333333333333333 1E2 7.\nv 0 123456.789012345 0\nf 1 2 3").mesh;
  EXPECT_EQ(mesh.positions[0], dvec3(0.1, 1e-3, -0.5));
  EXPECT_EQ(mesh.positions[1], dvec3(0.3333333333333333, 1e2, 7.0));
  EXPECT_EQ(mesh.positions[2].y, 123456.789012345);
}

TEST_F(MeshFileTest, ConcavePolygonMakesTheRightSolid) {
  std::string text;  // an L as a prism of height 2, its floor turned over
  const std::vector<dvec2> corners = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
  for (const double z : {0.0, 2.0}) {
    for (const dvec2& c : corners) {
      text +=
          "v " + std::to_string(c.x) + " " + std::to_string(c.y) + " " + std::to_string(z) + "\n";
    }
  }
  text += "f 6 5 4 3 2 1\nf 7 8 9 10 11 12\n";
  for (int i = 0; i < 6; ++i) {
    const int j = (i + 1) % 6;
    text += "f " + std::to_string(i + 1) + " " + std::to_string(j + 1) + " " +
            std::to_string(j + 7) + " " + std::to_string(i + 7) + "\n";
  }
  const Mesh mesh = read(text).mesh;
  EXPECT_EQ(mesh.triangles.size(), 20U);
  EXPECT_DOUBLE_EQ(enclosed_volume(mesh), 10.0);
  EXPECT_DOUBLE_EQ(surface_area(mesh), 34.0);
}

TEST_F(MeshFileTest, PolygonOfManyCornersIsWhole) {
  std::string text;
  std::string face = "f";
  for (int i = 0; i < 600; ++i) {  // tinyobjloader's own lists hold up to 255
    const double angle = 2 * std::numbers::pi * i / 600;
    text += "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0\n";
    face += " " + std::to_string(i + 1);
  }
  const Mesh mesh = read(text + face).mesh;
  EXPECT_EQ(mesh.triangles.size(), 598U);
  EXPECT_NEAR(surface_area(mesh), std::numbers::pi, 1e-3);
}

TEST_F(MeshFileTest, FillsInMissingNormalsAndUv) {
  const Mesh mesh =
      read(std::string(square) + "vn 0 3 4\nvn 0 0 0\nvt 0.5 0.25\nf 1/1/1 2/1/1 3/1/2\nf 1 3 4\n")
          .mesh;
  EXPECT_THAT(mesh.normals, ElementsAre(dvec3(0, 0.6, 0.8), dvec3(0, 0, 1), dvec3(0, 0, 1)));
  EXPECT_THAT(mesh.normal_triangles, ElementsAre(uvec3(0, 0, 1), uvec3(2, 2, 2)));
  EXPECT_THAT(mesh.uvs, ElementsAre(dvec2(0.5, 0.25), dvec2(0, 0)));
  EXPECT_THAT(mesh.uv_triangles, ElementsAre(uvec3(0, 0, 0), uvec3(1, 1, 1)));
}

TEST_F(MeshFileTest, NotesWhatItLeavesOut) {
  read(std::string(square) + "f 1 2 3\nf 1 2 2\nf 1 2\nf 1/7/9 3/-8 4\n");
  EXPECT_THAT(notes_.lines,
              ElementsAre("m.obj: triangles without area, left out: 1",
                          "m.obj: faces with fewer than three corners, left out: 1",
                          "m.obj: normals or uv that faces name and that are not there, done "
                          "without: 3"));
}

TEST_F(MeshFileTest, SaysWhatIsWrongAndWhere) {
  const std::string head(square);
  const std::string missing =
      "a face names a vertex that is not there (the file has 4); export the mesh again";
  EXPECT_EQ(error_of(head + "f 1 2 3\nf 1 2 5\n"), "m.obj:6: " + missing);
  EXPECT_EQ(error_of(head + "f 1 2 -5\n"), "m.obj:5: " + missing);
  EXPECT_EQ(error_of(head + "f 1 2 0\n"), "m.obj:5: " + missing);
  EXPECT_EQ(error_of(head + "f 1 2 x\n"), "m.obj:5: " + missing);
  EXPECT_EQ(error_of(head + "f 1 2 \\\n 3\n\nf 1 2 99999999999\n"), "m.obj:8: " + missing);
  EXPECT_EQ(error_of(head + "f 1 2 99999999999999999999\n"), "m.obj:5: " + missing);
  EXPECT_EQ(error_of(head + "f 1 2 3\nf 1 2 -99999999999999999999\n"), "m.obj:6: " + missing);
  const std::string number = "a vertex is not three finite numbers; mend the coordinates";
  for (const std::string bad : {"nan 0 0", "0 inf 0", "0 0", "1,5 0 0", "0 1e999 0", "a b c"}) {
    EXPECT_EQ(error_of("v 0 0 0\nv " + bad + "\nv 0 1 0\nf 1 2 3"), "m.obj:2: " + number) << bad;
  }
  EXPECT_EQ(error_of("v 0 0 0\nv 1e19 0 0\nv 0 1 0\nf 1 2 3"),
            "m.obj:2: a vertex lies farther out than 1e18; mend the coordinates");
  EXPECT_EQ(error_of(""), "m.obj: holds no faces; name a mesh with triangles or polygons");
  EXPECT_EQ(error_of(head), "m.obj: holds no faces; name a mesh with triangles or polygons");
  EXPECT_EQ(error_of(head + "f 1 2 2"),
            "m.obj: holds no face with an area; name a mesh with triangles or polygons");
  EXPECT_EQ(error_of(std::string("v 0 0 0\0", 8)),
            "m.obj: is not a text file; name a Wavefront OBJ");
}

TEST_F(MeshFileTest, MissingFileAndFolderAreErrors) {
  try {
    read_obj(folder_ / "nothing.obj", notes_);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("nothing.obj: no such file; check the path"));
  }
  EXPECT_THROW(read_obj(folder_, notes_), Error);
}

TEST_F(MeshFileTest, ReadsMaterials) {
  write_file(folder_ / "my paint.mtl",
             "newmtl red  wine\nKd 0.5 0 0\nKs 0.1 0.2 0.3\nNs 90\nd 0.25\nNi 1.33\nKe 0 1 0\n"
             "newmtl glass\nKd 2 -1 0.5\nTr 0.75\nNs 5000\nmap_Kd -s 1 1 1 pic ture.png\n");
  write_file(folder_ / "pic ture.png", "a picture");
  const MeshFile file = read(
      "mtllib my paint.mtl\n" + std::string(square) +
      "f 1 2 3\nusemtl glass # the bowl\nf 1 3 4\nusemtl red  wine\nf 1 2 4\nusemtl lost\nf 2 3 4");
  const auto& m = file.mesh.materials;
  ASSERT_EQ(m.size(), 4U);
  EXPECT_EQ(m[0].name, "default");
  EXPECT_EQ(m[1].name, "glass");
  EXPECT_EQ(m[1].color, linear_from_srgb({1, 0, 0.5}));
  EXPECT_EQ(m[1].opacity, 0.25);
  EXPECT_EQ(m[1].shininess, 1000.0);
  EXPECT_EQ(m[1].texture, folder_ / "pic ture.png");
  EXPECT_EQ(m[2].color, linear_from_srgb({0.5, 0, 0}));
  EXPECT_EQ(m[2].specular, dvec3(0.1, 0.2, 0.3));
  EXPECT_EQ(m[2].emission, dvec3(0, 1, 0));
  EXPECT_EQ(m[2].opacity, 0.25);
  EXPECT_EQ(m[2].refraction_index, 1.33);
  EXPECT_EQ(m[3].name, "lost");
  EXPECT_EQ(m[3].color, Material().color);
  EXPECT_THAT(file.mesh.triangle_materials, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(file.files,
              ElementsAre(folder_ / "m.obj", folder_ / "my paint.mtl", folder_ / "pic ture.png"));
  EXPECT_THAT(notes_.lines, IsEmpty());
}

TEST_F(MeshFileTest, TakesBlendersColoursAsLinear) {
  write_file(folder_ / "b.mtl", "# Blender 3.4.1 MTL File: 'a.blend'\nnewmtl a\nKd 0.5 0 0\n");
  const MeshFile file = read("mtllib b.mtl\n" + std::string(square) + "usemtl a\nf 1 2 3\n");
  EXPECT_EQ(file.mesh.materials.at(0).color, dvec3(0.5, 0, 0));
}

TEST_F(MeshFileTest, ReadsPhysicalMaterials) {
  write_file(folder_ / "p.mtl", "newmtl a\nPr 0.25\nPm 2\nPs 0.5\nPc 0.75\nnewmtl b\nNs 10\n");
  const MeshFile file =
      read("mtllib p.mtl\n" + std::string(square) + "usemtl a\nf 1 2 3\nusemtl b\nf 1 3 4\n");
  const auto& m = file.mesh.materials;
  ASSERT_EQ(m.size(), 2U);
  EXPECT_EQ(m[0].roughness, 0.25);
  EXPECT_EQ(m[0].metallic, 1.0);
  EXPECT_EQ(m[0].sheen, 0.5);
  EXPECT_EQ(m[0].clearcoat, 0.75);
  EXPECT_EQ(m[1].roughness, std::nullopt);
}

TEST_F(MeshFileTest, TakesNoFileFromOutsideTheFolder) {
  const fs::path inner = folder_ / "inner";
  write_file(folder_ / "secret.png", "x");
  write_file(folder_ / "outer.mtl", "newmtl a\nKd 1 0 0\n");
  write_file(inner / "kept" / "good.png", "x");
  fs::create_symlink(folder_ / "secret.png", inner / "link.png");
  const std::string body = std::string(square) + "usemtl a\nf 1 2 3\n";
  const auto texture_of = [&](const std::string& name) {
    write_file(inner / "m.mtl", "newmtl a\nKd 0 1 0\nmap_Kd " + name + "\n");
    write_file(inner / "m.obj", "mtllib m.mtl\n" + body);
    return read_obj(inner / "m.obj", notes_).mesh.materials.at(0).texture;
  };
  for (const std::string bad :
       {"../secret.png", "kept/../../secret.png", "..\\secret.png", "link.png", "/etc/passwd",
        "kept", "missing.png", "../inner/../secret.png"}) {
    EXPECT_EQ(texture_of(bad), fs::path()) << bad;
    EXPECT_EQ(notes_.lines.back(), "material 'a': texture '" + bad +
                                       "' is not a file in the mesh's folder; the colour is used");
  }
  EXPECT_EQ(texture_of("kept\\good.png"), inner / "kept" / "good.png");
  EXPECT_EQ(texture_of("../inner/kept/good.png"), inner / "kept" / "good.png");

  write_file(inner / "m.obj", "mtllib ../outer.mtl\n" + body);
  const MeshFile file = read_obj(inner / "m.obj", notes_);
  EXPECT_EQ(file.mesh.materials.at(0).color, Material().color);
  EXPECT_THAT(file.files, ElementsAre(inner / "m.obj"));
  EXPECT_EQ(notes_.lines.back(),
            "material file '../outer.mtl' is not a file in the mesh's folder; "
            "its materials are left grey");
}

TEST_F(MeshFileTest, WritesWhatItReads) {
  for (const StarterModel& model : starter_models()) {
    Mesh mesh = model.make();
    mesh.uvs = {{0.1, 0.2}, {0.123456789, 1}};
    mesh.uv_triangles.assign(mesh.triangles.size(), uvec3(0, 1, 1));
    Material second;
    second.name = "second one";
    second.color = {0.25, 0.5, 0.75};
    second.roughness = 0.4;
    second.sheen = 0.3;
    mesh.materials.resize(1);
    mesh.materials.push_back(second);
    mesh.triangle_materials.assign(mesh.triangles.size(), 0);
    mesh.triangle_materials.back() = 1;
    write_obj(folder_ / "w.obj", mesh, "first line\nsecond line");
    const MeshFile back = read_obj(folder_ / "w.obj", notes_);
    EXPECT_EQ(back.mesh.positions, mesh.positions);
    EXPECT_EQ(back.mesh.triangles, mesh.triangles);
    EXPECT_EQ(back.mesh.normal_triangles, mesh.normal_triangles);
    EXPECT_EQ(back.mesh.uvs, mesh.uvs);
    EXPECT_EQ(back.mesh.uv_triangles, mesh.uv_triangles);
    EXPECT_EQ(back.mesh.triangle_materials, mesh.triangle_materials);
    EXPECT_EQ(back.mesh.materials.at(1).name, "second_one");
    EXPECT_NEAR(glm::distance(back.mesh.materials.at(1).color, second.color), 0.0, 1e-9);
    EXPECT_EQ(back.mesh.materials.at(1).roughness, second.roughness);
    EXPECT_EQ(back.mesh.materials.at(1).sheen, second.sheen);
    EXPECT_EQ(back.mesh.materials.at(0).roughness, std::nullopt);
    EXPECT_EQ(back.files.size(), 2U);
  }
  EXPECT_THAT(read_file(folder_ / "w.obj"), testing::StartsWith("# first line\n# second line\n"));
  EXPECT_THAT(notes_.lines, IsEmpty());
}

TEST_F(MeshFileTest, SurvivesRandomDamage) {
  write_obj(folder_ / "w.obj", make_teacup(8), "");
  const std::string whole = read_file(folder_ / "w.obj");
  std::uint64_t state = 1;
  for (int i = 0; i < 100; ++i) {
    std::string text = whole;
    for (int k = 0; k < 8; ++k) {
      state = state * 6364136223846793005ULL + 1442695040888963407ULL;
      text[(state >> 20) % text.size()] = static_cast<char>("0-/ \nf.e#\\v9"[(state >> 56) % 12]);
    }
    try {
      EXPECT_GT(read(text).mesh.triangles.size(), 0U);
    } catch (const Error&) {
    }
  }
}

}  // namespace
}  // namespace collage
