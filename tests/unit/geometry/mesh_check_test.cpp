#include "geometry/mesh_check.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "base/rng.h"
#include "geometry/models.h"
#include "test_meshes.h"

namespace collage {
namespace {

TEST(MeshCheck, CubeIsOneClosedPart) {
  const MeshReport report = check_mesh(make_cube());
  EXPECT_EQ(report.triangles, 12U);
  EXPECT_EQ(report.vertices, 8U);
  EXPECT_EQ(report.parts, 1U);
  EXPECT_TRUE(report.closed);
  EXPECT_EQ(report.boundary_edges + report.nonmanifold_edges + report.inconsistent_edges, 0U);
  EXPECT_EQ(text_of(report), "12 triangles in 1 part, closed, volume 1, 1 x 1 x 1");
}

TEST(MeshCheck, CornersAtOnePlaceAreOne) {
  Mesh soup;
  const Mesh cube = make_cube();
  for (std::size_t t = 0; t < cube.triangles.size(); ++t) {
    const auto first = static_cast<std::uint32_t>(soup.positions.size());
    for (int k = 0; k < 3; ++k) {
      soup.positions.push_back(cube.corner(t, k));
    }
    soup.triangles.emplace_back(first, first + 1, first + 2);
  }
  EXPECT_EQ(check_mesh(soup).vertices, 8U);
  EXPECT_TRUE(check_mesh(soup).closed);
}

TEST(MeshCheck, SaysWhatIsWrong) {
  Mesh mesh = make_cube();
  mesh.triangles.pop_back();
  std::swap(mesh.triangles[0].x, mesh.triangles[0].y);
  mesh.triangles.emplace_back(0, 0, 1);
  append(mesh, make_cube({5, 0, 0}));
  const MeshReport report = check_mesh(mesh);
  EXPECT_EQ(report.parts, 2U);
  EXPECT_EQ(report.boundary_edges, 3U);
  EXPECT_EQ(report.inconsistent_edges, 3U);
  EXPECT_EQ(report.degenerate_triangles, 1U);
  EXPECT_EQ(text_of(report),
            "24 triangles in 2 parts, open, 3 boundary edges, 3 inconsistently oriented edges, "
            "1 degenerate triangle, 6 x 1 x 1");
}

TEST(MeshCheck, CubesThatShareAnEdgeAreNotManifold) {
  Mesh mesh = make_cube();
  append(mesh, make_cube({1, 1, 0}));
  const MeshReport report = check_mesh(mesh);
  EXPECT_EQ(report.parts, 1U);
  EXPECT_EQ(report.nonmanifold_edges, 1U);
  EXPECT_TRUE(report.closed);
}

TEST(Orient, RightMeshIsLeftAlone) {
  Mesh cube = make_cube();
  const Orientation done = orient(cube);
  EXPECT_EQ(done.sheets, 1U);
  EXPECT_EQ(text_of(done), "");
  EXPECT_EQ(cube.triangles, make_cube().triangles);
}

TEST(Orient, RandomlyTurnedTrianglesComeOutOutward) {
  Rng rng(4, 1);
  for (int i = 0; i < 20; ++i) {
    Mesh mesh = make_sphere(2);
    const double volume = enclosed_volume(mesh);
    for (uvec3& t : mesh.triangles) {
      if (rng.below(2) == 0) {
        std::swap(t.y, t.z);
      }
    }
    orient(mesh);
    EXPECT_EQ(check_mesh(mesh).inconsistent_edges, 0U);
    EXPECT_NEAR(enclosed_volume(mesh), volume, 1e-12);
  }
}

TEST(Orient, SaysWhatItDid) {
  Mesh mesh = make_cube();
  append(mesh, reversed(make_cube({3, 0, 0})));
  append(mesh, make_cube({6, 0, 0}));
  std::swap(mesh.triangles[0].x, mesh.triangles[0].y);
  EXPECT_EQ(text_of(orient(mesh)),
            "turned 1 of 3 parts outside out, turned 1 triangle to agree with the rest");
  EXPECT_DOUBLE_EQ(enclosed_volume(mesh), 3.0);
}

TEST(Orient, PartsThatOnlyTouchAreTurnedByThemselves) {
  Mesh mesh = make_cube();
  append(mesh, reversed(make_cube({1, 1, 0})));
  EXPECT_EQ(text_of(orient(mesh)), "turned 1 of 2 parts outside out");
  EXPECT_DOUBLE_EQ(enclosed_volume(mesh), 2.0);
}

TEST(Orient, PatchesThatNeedEachOtherAreTurnedTogether) {
  Mesh mesh = make_cube();  // with an inner wall across it, twice: four triangles at its rim
  append(mesh, reversed(make_cube()));
  mesh.triangles.erase(mesh.triangles.begin() + 14, mesh.triangles.end());
  mesh.triangles[12] = {0, 3, 2};
  mesh.triangles[13] = {0, 1, 3};
  mesh.triangles.insert(mesh.triangles.end(), {{0, 2, 3}, {0, 3, 1}});
  ASSERT_TRUE(check_mesh(mesh).closed);
  ASSERT_GT(check_mesh(mesh).nonmanifold_edges, 0U);
  EXPECT_EQ(text_of(orient(mesh)), "");
  reverse_orientation(mesh);
  orient(mesh);
  EXPECT_EQ(check_mesh(mesh).inconsistent_edges, 0U);
  EXPECT_DOUBLE_EQ(enclosed_volume(mesh), 1.0);
}

TEST(Orient, CavityStaysACavity) {
  Mesh hollow = make_cube({0, 0, 0}, 3.0);
  append(hollow, reversed(make_cube({1, 1, 1}, 1.0)));
  Mesh inside_out = reversed(hollow);
  orient(hollow);
  EXPECT_DOUBLE_EQ(enclosed_volume(hollow), 26.0);
  EXPECT_EQ(orient(inside_out).turned_sheets, 2U);
  EXPECT_DOUBLE_EQ(enclosed_volume(inside_out), 26.0);
}

TEST(Orient, InsideOutPartBesideAnotherIsNoCavity) {
  Mesh mesh = make_cube({0, 0, 0}, 3.0);
  append(mesh, reversed(make_cube({2.5, 1, 1}, 1.0)));  // sticks out
  EXPECT_EQ(orient(mesh).turned_sheets, 1U);
  EXPECT_DOUBLE_EQ(enclosed_volume(mesh), 28.0);
}

TEST(Orient, OpenBowlIsTurnedAndFlatSheetIsNot) {
  Mesh bowl = make_sphere(3);
  std::erase_if(bowl.triangles, [&](const uvec3& t) { return bowl.positions[t.x].y > 0.3; });
  bowl.normals.clear();
  bowl.normal_triangles.clear();
  Mesh turned = reversed(bowl);
  EXPECT_EQ(orient(turned).turned_sheets, 1U);
  EXPECT_EQ(orient(bowl).turned_sheets, 0U);

  Mesh flat = make_cube();
  flat.triangles.resize(2);
  EXPECT_EQ(orient(flat).turned_sheets, 0U);
}

TEST(Orient, NormalsThatWereRightStayRight) {
  Mesh mesh = make_sphere(1);
  for (uvec3& t : mesh.triangles) {
    std::swap(t.y, t.z);
  }
  for (uvec3& t : mesh.normal_triangles) {
    std::swap(t.y, t.z);
  }
  Mesh wrong_normals = reversed(make_sphere(1));
  for (Mesh* each : {&mesh, &wrong_normals}) {
    orient(*each);
    for (std::size_t t = 0; t < each->triangles.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(each->normals[each->normal_triangles[t][k]], each->corner(t, k));
      }
    }
  }
}

TEST(Orient, MoebiusStripIsSaidAndLeft) {
  Mesh strip;
  constexpr std::uint32_t steps = 24;
  for (std::uint32_t i = 0; i < steps; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / steps;
    const dvec3 out(std::cos(angle), 0, std::sin(angle));
    const dvec3 across = std::cos(angle / 2) * out + std::sin(angle / 2) * dvec3(0, 1, 0);
    strip.positions.push_back(3.0 * out - across);
    strip.positions.push_back(3.0 * out + across);
  }
  for (std::uint32_t i = 0; i < steps; ++i) {
    const std::uint32_t a = 2 * i;
    const std::uint32_t b = i + 1 < steps ? 2 * i + 2 : 1;
    const std::uint32_t c = i + 1 < steps ? 2 * i + 3 : 0;
    strip.triangles.emplace_back(a, a + 1, c);
    strip.triangles.emplace_back(a, c, b);
  }
  const Mesh before = strip;
  const Orientation done = orient(strip);
  EXPECT_EQ(done.one_sided_sheets, 1U);
  EXPECT_EQ(text_of(done), "1 part with one side only");
  EXPECT_EQ(strip.triangles, before.triangles);
}

}  // namespace
}  // namespace collage
