#include "geometry/subdivision.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "geometry/cell_surface.h"
#include "geometry/polyhedra.h"
#include "mesh_quality.h"

namespace collage {
namespace {

/// A square ring of eight cubes: genus 1, with flat, straight and reflex places.
PolygonMesh make_ring() {
  constexpr std::array planes = {0.0, 1.0, 2.0, 3.0};
  constexpr std::array heights = {0.0, 1.0};
  return cell_surface(planes, heights, planes, [](const dvec3& p) {
    return p.x < 1.0 || p.x > 2.0 || p.z < 1.0 || p.z > 2.0;
  });
}

TEST(CatmullClark, KeepsGenusAndQuartersQuads) {
  const PolygonMesh ring = make_ring();
  const PolygonMesh smooth = catmull_clark(ring);
  EXPECT_EQ(smooth.faces.size(), 4 * ring.faces.size());
  EXPECT_EQ(euler_characteristic(smooth), 0);
  EXPECT_TRUE(is_closed_outward(smooth));
  EXPECT_EQ(catmull_clark(regular_octahedron()).faces.size(), 24U);
}

TEST(CatmullClark, PutsACubesPointsWhereTheRulesSay) {
  PolygonMesh cube = regular_cube();
  for (dvec3& corner : cube.positions) {
    corner *= std::sqrt(3.0);  // corners at ±1
  }
  const PolygonMesh smooth = catmull_clark(cube);
  // Corner: (F + 2R + 0 P) / 3, with F = 1/3 and R = 2/3 in each coordinate.
  EXPECT_NEAR(glm::distance(glm::abs(smooth.positions[0]), dvec3(5.0 / 9.0)), 0.0, 1e-12);
  for (const dvec3& p : smooth.positions) {
    dvec3 a = glm::abs(p);
    std::sort(&a.x, &a.x + 3);
    const bool known = glm::distance(a, dvec3(5.0 / 9.0)) < 1e-12 ||      // corner
                       glm::distance(a, dvec3(0, 0.75, 0.75)) < 1e-12 ||  // edge
                       glm::distance(a, dvec3(0, 0, 1)) < 1e-12;          // face
    EXPECT_TRUE(known) << a.x << " " << a.y << " " << a.z;
  }
}

TEST(DooSabin, KeepsGenusAndMakesAFaceOfEverything) {
  const PolygonMesh ring = make_ring();
  const std::size_t edges = edge_faces(ring).size() / 2;
  const PolygonMesh smooth = doo_sabin(ring);
  EXPECT_EQ(smooth.faces.size(), ring.faces.size() + edges + ring.positions.size());
  EXPECT_EQ(euler_characteristic(smooth), 0);
  EXPECT_TRUE(is_closed_outward(smooth));
}

TEST(DooSabin, ShrinksACubesFacesToHalfTheirWidth) {
  PolygonMesh cube = regular_cube();
  const PolygonMesh smooth = doo_sabin(cube);
  // For four corners the weights are 9/16, 3/16, 1/16, 3/16: each coordinate in the face is halved.
  const double half = std::sqrt(1.0 / 3.0);
  for (const dvec3& p : smooth.positions) {
    dvec3 a = glm::abs(p);
    std::sort(&a.x, &a.x + 3);
    EXPECT_NEAR(glm::distance(a, dvec3(half / 2, half / 2, half)), 0.0, 1e-12);
  }
  std::size_t triangles = 0;
  for (const PolygonMesh::Face& face : smooth.faces) {
    triangles += face.size() == 3 ? 1 : 0;
  }
  EXPECT_EQ(triangles, 8U);
}

TEST(Subdivision, RoundsOffACube) {
  for (PolygonMesh (*const subdivide)(const PolygonMesh&) : {catmull_clark, doo_sabin}) {
    PolygonMesh mesh = regular_cube();
    for (int i = 0; i < 4; ++i) {
      mesh = subdivide(mesh);
    }
    double least = 1e300;
    double most = 0.0;
    for (const dvec3& p : mesh.positions) {
      least = std::min(least, glm::length(p));
      most = std::max(most, glm::length(p));
    }
    EXPECT_LT(most / least, 1.2);  // a cube's is 1.73
  }
}

}  // namespace
}  // namespace collage
