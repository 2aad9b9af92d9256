#include "geometry/topology.h"

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace collage {
namespace {

using Parts = std::vector<std::uint32_t>;

TEST(Topology, PartsHangTogetherByVerticesAtTheSamePlace) {
  Mesh mesh;
  // Two triangles that share a place but no vertex, and one apart from both, stored between them.
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0},
                    {5, 1, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
  EXPECT_EQ(parts_by_vertices(mesh), (Parts{0, 1, 0}));
}

TEST(Topology, PartsAreNumberedByTheirFirstTriangles) {
  Mesh mesh = test::box_mesh(dvec3(0), dvec3(1));
  const Mesh other = test::box_mesh(dvec3(3), dvec3(4));
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  for (const uvec3& t : other.triangles) {
    mesh.triangles.insert(mesh.triangles.begin(), t + first);
  }
  Parts wanted(12, 0);
  wanted.resize(24, 1);
  EXPECT_EQ(parts_by_vertices(mesh), wanted);
}

TEST(Topology, NoTrianglesAreNoParts) { EXPECT_EQ(parts_by_vertices(Mesh()), Parts()); }

}  // namespace
}  // namespace collage
