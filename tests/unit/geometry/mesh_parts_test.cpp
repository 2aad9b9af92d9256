#include "geometry/mesh_parts.h"

#include <gtest/gtest.h>

#include "geometry/bounding_sphere.h"
#include "test_meshes.h"

namespace collage {
namespace {

Material named(const char* name) {
  Material material;
  material.name = name;
  return material;
}

TEST(MeshParts, PartsKeepTheirMaterialAndShareThoseOfOneName) {
  Mesh mesh;
  append_part(mesh, make_cube(), named("red"));
  append_part(mesh, make_cube(dvec3(2.0)), named("blue"));
  append_part(mesh, make_cube(dvec3(4.0)), named("red"));
  ASSERT_EQ(mesh.materials.size(), 2U);
  ASSERT_EQ(mesh.triangle_materials.size(), 36U);
  EXPECT_EQ(mesh.triangle_materials[0], 0U);
  EXPECT_EQ(mesh.triangle_materials[12], 1U);
  EXPECT_EQ(mesh.triangle_materials[35], 0U);
  EXPECT_NEAR(enclosed_volume(mesh), 3.0, 1e-12);
}

TEST(MeshParts, PaintsARangeOfTriangles) {
  Mesh mesh;
  append_part(mesh, make_cube(), named("red"));
  paint(mesh, named("blue"), 2, 4);
  EXPECT_EQ(mesh.triangle_materials,
            (std::vector<std::uint32_t>{0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(mesh.materials[1].name, "blue");
}

TEST(MeshParts, FitsTheUnitSphere) {
  const Mesh cube = in_unit_sphere(make_cube(dvec3(5.0, -3.0, 1.0), 7.0));
  const Sphere sphere = smallest_enclosing_sphere(cube.positions);
  EXPECT_NEAR(sphere.radius, 1.0, 1e-6);
  EXPECT_NEAR(glm::length(sphere.center), 0.0, 1e-6);
}

TEST(MeshParts, AModelHasOneMaterialAndNormals) {
  const Mesh model = make_model(make_cube(), named("red"), 30.0);
  EXPECT_EQ(model.materials.size(), 1U);
  EXPECT_EQ(model.normals.size(), 6U);
  EXPECT_EQ(model.normal_triangles.size(), model.triangles.size());
}

}  // namespace
}  // namespace collage
