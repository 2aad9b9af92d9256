#include "geometry/rind.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "geometry/extrusion.h"
#include "geometry/polyhedra.h"
#include "mesh_quality.h"

namespace collage {
namespace {

TEST(Rind, WithoutWindowsItIsAShellWithACavity) {
  const PolygonMesh cube = regular_cube();
  const Mesh shell = triangulated(rind(cube, 0.1, {}));
  EXPECT_EQ(check_mesh(shell).parts, 2U);
  const double side = 2.0 * std::sqrt(1.0 / 3.0);
  EXPECT_NEAR(enclosed_volume(shell), std::pow(side, 3.0) - std::pow(side - 0.2, 3.0), 1e-5);
}

TEST(Rind, EachWindowButTheFirstAddsOneToTheGenus) {
  PolygonMesh dodecahedron = regular_dodecahedron();
  std::vector<std::uint32_t> windows;
  for (std::uint32_t face = 0; face < 12; ++face) {
    extrude_face(dodecahedron, face, dvec3(0.0), 0.5);
    windows.push_back(face);
  }
  for (const std::size_t count : {1U, 2U, 12U}) {
    const PolygonMesh shell = rind(dodecahedron, 0.15, std::span(windows).first(count));
    EXPECT_EQ(shell.faces.size(), 2 * dodecahedron.faces.size() + 5 * count - 2 * count);
    EXPECT_TRUE(is_closed_outward(shell));
    EXPECT_EQ(genus_of(triangulated(shell)), static_cast<int>(count) - 1);
    EXPECT_EQ(self_intersections(triangulated(shell)), 0U);
  }
}

}  // namespace
}  // namespace collage
