#include "geometry/polygon_mesh.h"

#include <array>

#include <gtest/gtest.h>

#include "geometry/polyhedra.h"
#include "mesh_quality.h"

namespace collage {
namespace {

TEST(PolygonMesh, EachEdgeHasTheFaceOnItsLeft) {
  const PolygonMesh cube = regular_cube();
  const EdgeFaces edges = edge_faces(cube);
  EXPECT_EQ(edges.size(), 24U);
  for (const auto& [edge, left] : edges) {
    const PolygonMesh::Face& face = cube.faces[left.face];
    EXPECT_EQ(face[left.corner], edge.first);
    EXPECT_EQ(face[(left.corner + 1) % 4], edge.second);
    EXPECT_TRUE(edges.contains({edge.second, edge.first}));
  }
}

TEST(PolygonMesh, FacesKnowTheirMiddleAndNormal) {
  const PolygonMesh cube = regular_cube();
  for (std::uint32_t f = 0; f < 6; ++f) {
    const dvec3 middle = face_middle(cube, f);
    EXPECT_NEAR(glm::length(middle), std::sqrt(1.0 / 3.0), 1e-12);
    EXPECT_NEAR(glm::dot(face_normal(cube, f), glm::normalize(middle)), 1.0, 1e-12);
    EXPECT_EQ(face_towards(cube, middle + dvec3(0.2, 0.1, -0.2)), f);
  }
}

TEST(PolygonMesh, RaisedFacesGrowWalls) {
  PolygonMesh mesh = regular_tetrahedron();
  const dvec3 out = face_normal(mesh, 0);
  std::array<dvec3, 3> upper;
  for (int k = 0; k < 3; ++k) {
    upper[k] = mesh.positions[mesh.faces[0][k]] + out;
  }
  const double before = enclosed_volume(triangulated(mesh));
  raise_face(mesh, 0, upper);
  EXPECT_EQ(mesh.faces.size(), 7U);
  EXPECT_TRUE(is_closed_outward(mesh));
  const double side = std::sqrt(8.0 / 3.0);
  EXPECT_NEAR(enclosed_volume(triangulated(mesh)) - before, std::sqrt(3.0) / 4.0 * side * side,
              1e-5);
}

TEST(PolygonMesh, TrianglesTakeConcaveFacesAsTheyAre) {
  PolygonMesh arrow;
  arrow.positions = {{0, 0, 0}, {2, -1, 0}, {0.5, 0, 0}, {2, 1, 0}};
  arrow.faces = {{0, 1, 2, 3}};
  EXPECT_NEAR(surface_area(triangulated(arrow)), 0.5, 1e-12);
}

}  // namespace
}  // namespace collage
