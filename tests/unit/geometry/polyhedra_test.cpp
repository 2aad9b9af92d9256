#include "geometry/polyhedra.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "mesh_quality.h"

namespace collage {
namespace {

void expect_polyhedron(const PolygonMesh& mesh, std::size_t vertices, std::size_t faces) {
  EXPECT_EQ(mesh.positions.size(), vertices);
  EXPECT_EQ(mesh.faces.size(), faces);
  EXPECT_EQ(euler_characteristic(mesh), 2);
  EXPECT_TRUE(is_closed_outward(mesh));
  for (const dvec3& corner : mesh.positions) {
    EXPECT_NEAR(glm::length(corner), 1.0, 1e-12);
  }
}

TEST(Polyhedra, AreWhole) {
  expect_polyhedron(regular_tetrahedron(), 4, 4);
  expect_polyhedron(regular_cube(), 8, 6);
  expect_polyhedron(regular_octahedron(), 6, 8);
  expect_polyhedron(regular_dodecahedron(), 20, 12);
  expect_polyhedron(regular_prism(3), 6, 5);
  expect_polyhedron(regular_prism(7), 14, 9);
}

TEST(Polyhedra, RegularOnesHaveOneLengthOfEdge) {
  for (const PolygonMesh& mesh : {regular_tetrahedron(), regular_cube(), regular_octahedron(),
                                  regular_dodecahedron(), regular_prism(5)}) {
    double shortest = 1e300;
    double longest = 0.0;
    for (const auto& [edge, left] : edge_faces(mesh)) {
      const double length = glm::distance(mesh.positions[edge.first], mesh.positions[edge.second]);
      shortest = std::min(shortest, length);
      longest = std::max(longest, length);
    }
    EXPECT_NEAR(shortest, longest, 1e-12);
  }
}

}  // namespace
}  // namespace collage
