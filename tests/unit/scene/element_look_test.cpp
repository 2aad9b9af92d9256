#include "scene/element_look.h"

#include "unit/scene/support.h"

namespace collage {
namespace {

TEST(ElementLook, DecodesSrgb) {
  EXPECT_EQ(linear_color("#000000"), dvec3(0.0));
  EXPECT_EQ(linear_color("#FFffFF"), dvec3(1.0));
  EXPECT_NEAR(linear_color("#800000").x, 0.21586, 1e-5);
  EXPECT_NEAR(linear_color("#00000a").z, 0.0030353, 1e-6);
}

TEST(ElementLook, PrefersTheScenesColour) {
  Mesh mesh = testing::cube();
  mesh.materials.resize(2);
  mesh.triangle_materials.resize(mesh.triangles.size(), 1);
  const ElementLook look = look_of({"a", mesh, "#ff0000"}, 0);
  ASSERT_EQ(look.materials.size(), 1U);
  EXPECT_EQ(look.materials[0].color, dvec3(1, 0, 0));
  EXPECT_EQ(look.assignment, ElementLook::Assignment::all_the_first);
}

TEST(ElementLook, TakesTheMeshsMaterials) {
  Mesh mesh = testing::cube();
  mesh.materials.resize(2);
  EXPECT_EQ(look_of({"a", mesh, ""}, 0).assignment, ElementLook::Assignment::all_the_first);
  mesh.triangle_materials.resize(mesh.triangles.size(), 1);
  EXPECT_EQ(look_of({"a", mesh, ""}, 0).assignment, ElementLook::Assignment::by_triangle);
}

TEST(ElementLook, PicksFromThePaletteElse) {
  const Mesh mesh = testing::cube();
  const auto color = [&](std::size_t k) {
    return look_of({"a", mesh, ""}, k).materials.at(0).color;
  };
  EXPECT_NE(color(0), color(1));
  EXPECT_EQ(color(1), color(9));
}

}  // namespace
}  // namespace collage
