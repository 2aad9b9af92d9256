#include "geometry/cell_surface.h"

#include <array>

#include <gtest/gtest.h>

#include "mesh_quality.h"

namespace collage {
namespace {

constexpr std::array xs = {0.0, 1.0, 3.0, 4.0};
constexpr std::array ys = {-1.0, 0.0, 0.5, 2.0};
constexpr std::array zs = {0.0, 2.0, 3.0, 5.0};

TEST(CellSurface, WrapsTheCellsThatAreSolid) {
  const PolygonMesh all = cell_surface(xs, ys, zs, [](const dvec3&) { return true; });
  EXPECT_EQ(all.faces.size(), 6U * 9U);
  EXPECT_EQ(euler_characteristic(all), 2);
  EXPECT_TRUE(is_closed_outward(all));
  EXPECT_NEAR(enclosed_volume(triangulated(all)), 4.0 * 3.0 * 5.0, 1e-9);
}

TEST(CellSurface, HolesThroughItAreHandles) {
  const PolygonMesh ring = cell_surface(
      xs, ys, zs, [](const dvec3& p) { return p.x < 1 || p.x > 3 || p.z < 2 || p.z > 3; });
  EXPECT_EQ(genus_of(triangulated(ring)), 1);
  EXPECT_NEAR(enclosed_volume(triangulated(ring)), (4.0 * 5.0 - 2.0 * 1.0) * 3.0, 1e-9);
}

}  // namespace
}  // namespace collage
