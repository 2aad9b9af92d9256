#include "geometry/cell_crossings.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace collage {
namespace {

constexpr int cells_per_side = 16;

std::size_t cell_of(const dvec3& point) {
  const glm::ivec3 cell(glm::floor((point + 1.0) * (0.5 * cells_per_side)));
  return static_cast<std::size_t>((cell.z * cells_per_side + cell.y) * cells_per_side + cell.x);
}

dvec3 middle(std::size_t cell) {
  const std::size_t side = cells_per_side;
  return (dvec3(static_cast<double>(cell % side), static_cast<double>(cell / side % side),
                static_cast<double>(cell / (side * side))) +
          0.5) *
             (2.0 / cells_per_side) -
         1.0;
}

/// A box in a box, turned the same way round: twice inside in the middle.
Mesh nested_boxes() {
  Mesh mesh = test::box_mesh(dvec3(-0.51), dvec3(0.49));
  const Mesh inner = test::box_mesh(dvec3(-0.31), dvec3(0.19));
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), inner.positions.begin(), inner.positions.end());
  for (const uvec3& triangle : inner.triangles) {
    mesh.triangles.push_back(triangle + first);
  }
  return mesh;
}

/// Every triangle's solid angle is the slow twin.
TEST(CellCrossings, CountWhatTheWindingNumberCounts) {
  for (const Mesh& mesh :
       {test::torus_mesh(0.7, 0.25, 24, 12), test::blob_mesh(0.7, 0.3, 12), nested_boxes()}) {
    const CellCrossings crossings(mesh, WindingNumber(mesh), cells_per_side);
    Rng rng(6, 2);
    int answered = 0;
    int within = 0;
    constexpr int queries = 3000;
    for (int i = 0; i < queries; ++i) {
      const dvec3 point = test::random_point(rng, 1.0);
      const auto winding = crossings.winding_at(cell_of(point), point);
      if (winding) {
        ++answered;
        within += *winding != 0 ? 1 : 0;
        ASSERT_EQ(*winding, std::lround(winding_number(mesh, point)));
      }
    }
    EXPECT_GT(answered, queries * 99 / 100);
    EXPECT_GT(within, queries / 20);
  }
}

TEST(CellCrossings, EmptyCellsHaveOneWindingNumberThroughout) {
  const Mesh mesh = nested_boxes();
  const CellCrossings crossings(mesh, WindingNumber(mesh), cells_per_side);
  Rng rng(7, 2);
  std::array<int, 3> cells_of_winding{};
  for (std::size_t cell = 0; cell < 16 * 16 * 16; ++cell) {
    const int at_middle = crossings.winding_at_middle(cell);
    ASSERT_EQ(at_middle, std::lround(winding_number(mesh, middle(cell))));
    if (crossings.is_empty(cell)) {
      ++cells_of_winding.at(static_cast<std::size_t>(at_middle));
      const dvec3 point = middle(cell) + test::random_point(rng, 0.999 / cells_per_side);
      ASSERT_EQ(at_middle, std::lround(winding_number(mesh, point)));
    }
  }
  EXPECT_GT(*std::ranges::min_element(cells_of_winding), 20);
}

/// On the surface, on an edge and in a corner there is no saying.
TEST(CellCrossings, DoNotGuessWhereItIsTooCloseToCall) {
  const Mesh mesh = test::box_mesh(dvec3(-0.53), dvec3(0.53));
  const CellCrossings crossings(mesh, WindingNumber(mesh), cells_per_side);
  for (const dvec3& point : {dvec3(0.53, 0.1, 0.2), dvec3(0.53, 0.53, 0.2), dvec3(0.53)}) {
    EXPECT_FALSE(crossings.winding_at(cell_of(point), point));
  }
}

}  // namespace
}  // namespace collage
