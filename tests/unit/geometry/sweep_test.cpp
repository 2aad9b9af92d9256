#include "geometry/sweep.h"

#include <array>
#include <numbers>

#include <gtest/gtest.h>

#include "mesh_quality.h"

namespace collage {
namespace {

TEST(Sweep, LatheMakesACylinderWithPolesOrWithSealedEnds) {
  const std::array<ProfilePoint, 4> with_poles = {{{0, 0}, {1, 0}, {1, 2}, {0, 2}}};
  Mesh mesh;
  append_rings(mesh, lathe(with_poles, 64, 0.0));
  EXPECT_EQ(mesh.triangles.size(), 4U * 64U);
  EXPECT_EQ(genus_of(mesh), 0);
  EXPECT_NEAR(enclosed_volume(mesh), 2.0 * std::numbers::pi, 0.02);

  Mesh sealed;
  append_rings(sealed, lathe(std::span(with_poles).subspan(1, 2), 64, 0.0));
  EXPECT_NEAR(enclosed_volume(sealed), enclosed_volume(mesh), 1e-9);
}

TEST(Sweep, BandsAreWhereBandStartSays) {
  const std::array<ProfilePoint, 5> profile = {{{0, 0}, {1, 0}, {1, 2}, {1, 3}, {0, 3}}};
  constexpr std::size_t points = 7;
  Mesh mesh;
  append_rings(mesh, lathe(profile, points, 0.0));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double y = (mesh.corner(t, 0).y + mesh.corner(t, 1).y + mesh.corner(t, 2).y) / 3.0;
    const bool in_band = t >= band_start(2, points) && t < band_start(3, points);
    EXPECT_EQ(y > 2.1 && y < 2.9, in_band) << t;
  }
}

TEST(Sweep, ALoopOfRingsIsATorus) {
  std::vector<Ring> rings;
  constexpr int count = 48;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    const dvec3 out(std::cos(angle), std::sin(angle), 0.0);
    const dvec3 along(-out.y, out.x, 0.0);
    rings.push_back(
        section_ring({3.0 * out, along, out, glm::cross(along, out)}, ellipse(1.0, 1.0, 32)));
  }
  Mesh mesh;
  append_ring_loop(mesh, rings);
  EXPECT_EQ(mesh.triangles.size(), 2U * count * 32U);
  EXPECT_EQ(genus_of(mesh), 1);
  EXPECT_NEAR(enclosed_volume(mesh) / (6.0 * std::numbers::pi * std::numbers::pi), 1.0, 0.02);
}

TEST(Sweep, SectionsScaleAboutTheCurve) {
  const Frame frame{{1, 2, 3}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
  const std::array<dvec2, 1> section = {{{2, 1}}};
  EXPECT_EQ(section_ring(frame, section, 3.0)[0], dvec3(7, 5, 3));
}

}  // namespace
}  // namespace collage
