#include "geometry/mesh_repair.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/rng.h"
#include "geometry/mesh_check.h"
#include "geometry/models.h"
#include "geometry/topology.h"
#include "support/meshes.h"
#include "test_meshes.h"

namespace collage {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Each triangle with corners of its own, each corner moved at random by up to `reach` an axis.
Mesh as_soup(const Mesh& mesh, double reach, Rng& rng) {
  Mesh soup;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto first = static_cast<std::uint32_t>(soup.positions.size());
    for (int k = 0; k < 3; ++k) {
      soup.positions.push_back(mesh.corner(t, k) + test::random_point(rng, reach));
    }
    soup.triangles.emplace_back(first, first + 1, first + 2);
  }
  return soup;
}

/// How many triangles have an edge between two places.
std::size_t triangles_at(const Mesh& mesh, const dvec3& a, const dvec3& b) {
  std::size_t count = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto has = [&](const dvec3& place) {
      return mesh.corner(t, 0) == place || mesh.corner(t, 1) == place || mesh.corner(t, 2) == place;
    };
    count += has(a) && has(b) ? 1 : 0;
  }
  return count;
}

/// weld() for meshes of triangles that are far larger than the distance within which it joins, by
/// the definition.
std::vector<dvec3> welded_slowly(const Mesh& mesh) {
  const double reach = weld_share * bounding_box(mesh).longest_side();
  std::vector<dvec3> welded = mesh.positions;
  std::vector<dvec3> still;
  for (dvec3& position : welded) {
    bool at_boundary = false;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        const dvec3 a = mesh.corner(t, k);
        const dvec3 b = mesh.corner(t, (k + 1) % 3);
        at_boundary =
            at_boundary || ((a == position || b == position) && triangles_at(mesh, a, b) == 1);
      }
    }
    if (at_boundary) {
      const auto first = std::ranges::find_if(
          still, [&](const dvec3& place) { return glm::distance(place, position) <= reach; });
      position = first == still.end() ? still.emplace_back(position) : *first;
    }
  }
  return welded;
}

TEST(Weld, CrackedMeshIsClosedAgain) {
  Rng rng(1, 0);
  Mesh soup = as_soup(make_cube({1e6, 0, 0}), 0.2 * weld_share, rng);
  EXPECT_FALSE(is_closed(soup));
  EXPECT_EQ(weld(soup), 28U);
  EXPECT_TRUE(is_closed(soup));
  EXPECT_NEAR(enclosed_volume(soup), 1.0, 1e-4);
  EXPECT_EQ(weld(soup), 0U);
}

TEST(Weld, TrianglesNormalsUvAndMaterialsStay) {
  Rng rng(2, 0);
  Mesh soup = as_soup(make_sphere(1), 0.2 * weld_share, rng);
  soup.normals = soup.positions;
  soup.normal_triangles = soup.triangles;
  soup.uvs.assign(soup.positions.size(), dvec2(0.5));
  soup.uv_triangles = soup.triangles;
  soup.triangle_materials.assign(soup.triangles.size(), 3);
  const Mesh before = soup;
  ASSERT_GT(weld(soup), 0U);
  EXPECT_EQ(soup.triangles, before.triangles);
  EXPECT_EQ(soup.normals, before.normals);
  EXPECT_EQ(soup.normal_triangles, before.normal_triangles);
  EXPECT_EQ(soup.uvs, before.uvs);
  EXPECT_EQ(soup.uv_triangles, before.uv_triangles);
  EXPECT_EQ(soup.triangle_materials, before.triangle_materials);
  for (std::size_t v = 0; v < soup.positions.size(); ++v) {
    EXPECT_LE(glm::distance(soup.positions[v], before.positions[v]), 2.0 * weld_share);
  }
}

TEST(Weld, AgreesWithItsSlowTwin) {
  int joined = 0;
  for (std::uint64_t i = 0; i < 60; ++i) {
    Rng rng(3, i);
    Mesh sphere = make_sphere(1);
    std::erase_if(sphere.triangles, [&](const uvec3&) { return rng.below(4) == 0; });
    Mesh soup = as_soup(sphere, rng.uniform() * weld_share, rng);
    append(soup, sphere);
    const std::vector<dvec3> wanted = welded_slowly(soup);
    Mesh fast = soup;
    const bool fewer = weld(fast) > 0;
    EXPECT_EQ(fast.positions, fewer ? wanted : soup.positions);
    joined += fewer ? 1 : 0;
  }
  EXPECT_GT(joined, 50);
}

TEST(Weld, VerticesInsideASurfaceStay) {
  Rng rng(4, 0);
  const Mesh sphere = make_sphere(2);
  Mesh twice = sphere;
  append(twice, sphere);
  for (std::size_t v = sphere.positions.size(); v < twice.positions.size(); ++v) {
    twice.positions[v] *= 1.0 + 0.3 * weld_share;
  }
  const Mesh before = twice;
  EXPECT_EQ(weld(twice), 0U);
  EXPECT_EQ(twice.positions, before.positions);
}

TEST(Weld, WhatJoinsNoEdgesStays) {
  Mesh mesh;  // two triangles that all but touch at a corner
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1e-6, 0, 0}, {-1, 0, 0}, {0, -1, 0}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  const Mesh before = mesh;
  EXPECT_EQ(weld(mesh), 0U);
  EXPECT_EQ(mesh.positions, before.positions);
}

TEST(Weld, NoTriangleLosesItsArea) {
  Rng rng(5, 0);
  Mesh mesh = as_soup(make_cube(), 0.2 * weld_share, rng);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {{0.5, 3, 0}, {0.5 + 1e-6, 3, 0}, {0.5, 3.5, 0}});
  mesh.triangles.emplace_back(first, first + 1, first + 2);
  EXPECT_EQ(weld(mesh), 28U);
  const MeshReport report = check_mesh(mesh);
  EXPECT_EQ(report.boundary_edges, 3U);
  EXPECT_EQ(report.degenerate_triangles, 0U);
}

/// The unit sphere without the triangles round some of its vertices.
Mesh sphere_without(const std::vector<dvec3>& directions) {
  Mesh sphere = make_sphere(4);
  for (const dvec3& direction : directions) {
    const auto nearest = std::ranges::min_element(sphere.positions, {}, [&](const dvec3& position) {
      return glm::distance(position, direction);
    });
    const auto v = static_cast<std::uint32_t>(nearest - sphere.positions.begin());
    for (std::size_t t = sphere.triangles.size(); t-- > 0;) {
      const uvec3& corners = sphere.triangles[t];
      if (corners.x == v || corners.y == v || corners.z == v) {
        const auto place = static_cast<std::ptrdiff_t>(t);
        sphere.triangles.erase(sphere.triangles.begin() + place);
        sphere.normal_triangles.erase(sphere.normal_triangles.begin() + place);
      }
    }
  }
  return sphere;
}

TEST(CloseHoles, SmallHolesAreClosed) {
  Mesh sphere = sphere_without({{1, 0, 0}, {0, 1, 0}, {-1, -1, 0}});
  ASSERT_EQ(check_mesh(sphere).boundary_edges, 18U);
  const ClosedHoles closed = close_holes(sphere);
  EXPECT_EQ(closed.holes, 3U);
  EXPECT_EQ(closed.triangles, 12U);
  EXPECT_TRUE(is_closed(sphere));
  EXPECT_NEAR(enclosed_volume(sphere), enclosed_volume(make_sphere(4)), 1e-3);
  EXPECT_EQ(close_holes(sphere).holes, 0U);
}

TEST(CloseHoles, EachMissingTriangleComesBack) {
  const Mesh whole = make_sphere(3);
  for (std::size_t t = 0; t < whole.triangles.size(); t += 7) {
    Mesh mesh = whole;
    mesh.normals.clear();
    mesh.normal_triangles.clear();
    std::swap(mesh.triangles[t], mesh.triangles.back());
    const uvec3 missing = mesh.triangles.back();
    mesh.triangles.pop_back();
    ASSERT_EQ(close_holes(mesh).triangles, 1U);
    uvec3 added = mesh.triangles.back();
    while (added.x != missing.x) {
      added = {added.y, added.z, added.x};
    }
    EXPECT_EQ(added, missing);
  }
}

TEST(CloseHoles, LidsTakeAfterTheSurfaceRoundThem) {
  Mesh mesh = sphere_without({{1, 0, 0}});
  mesh.triangle_materials.assign(mesh.triangles.size(), 0);
  mesh.uv_triangles = mesh.triangles;
  for (const dvec3& position : mesh.positions) {
    mesh.uvs.emplace_back(position.y, position.z);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    mesh.triangle_materials[t] = mesh.corner(t, 0).x > 0.5 ? 7 : 2;
  }
  const std::size_t first = mesh.triangles.size();
  ASSERT_EQ(close_holes(mesh).triangles, 4U);
  ASSERT_EQ(mesh.normal_triangles.size(), first + 4);
  for (std::size_t t = first; t < first + 4; ++t) {
    EXPECT_EQ(mesh.triangle_materials.at(t), 7U);
    EXPECT_EQ(mesh.uv_triangles.at(t), mesh.triangles.at(t));
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(mesh.normals[mesh.normal_triangles[t][k]], mesh.corner(t, k));
    }
  }
}

TEST(CloseHoles, NormalsThatPointInwardsAreNotTaken) {
  Mesh mesh = sphere_without({{1, 0, 0}});
  for (dvec3& normal : mesh.normals) {
    normal = -normal;
  }
  const std::size_t first = mesh.triangles.size();
  ASSERT_EQ(close_holes(mesh).triangles, 4U);
  for (std::size_t t = first; t < first + 4; ++t) {
    EXPECT_GT(mesh.normals[mesh.normal_triangles[t].x].x, 0.9);
  }
}

/// What has to stay open.
Mesh pipe() {
  Mesh mesh = test::box_mesh(dvec3(0.0), dvec3(1.0, 20.0, 1.0));
  std::erase_if(mesh.triangles, [&](const uvec3& t) {
    const dvec3 y(mesh.positions[t.x].y, mesh.positions[t.y].y, mesh.positions[t.z].y);
    return y.x == y.y && y.y == y.z;
  });
  return mesh;
}

Mesh sieve() {
  Mesh mesh = sphere_without({{1, -1, 0}, {0, -1, 1}});
  std::erase_if(mesh.triangles, [&](const uvec3& t) { return mesh.positions[t.x].y > 0.3; });
  return mesh;
}

Mesh holes_that_touch() {
  Mesh mesh = make_sphere(3);
  const uvec3 first = mesh.triangles[0];
  std::erase(mesh.triangles, first);
  const auto other = std::ranges::find_if(mesh.triangles, [&](const uvec3& t) {
    const auto shared = [&](std::uint32_t v) {
      return v == first.x || v == first.y || v == first.z;
    };
    return int{shared(t.x)} + int{shared(t.y)} + int{shared(t.z)} == 1;
  });
  mesh.triangles.erase(other);
  return mesh;
}

Mesh many_sided_hole() {
  Mesh mesh = test::blob_mesh(1.0, 0.0, 40);  // 80 triangles at each pole
  std::erase_if(mesh.triangles, [](const uvec3& t) { return t.x == 0; });
  return mesh;
}

Mesh flat_sheet() {
  Mesh mesh = make_cube();
  mesh.triangles.resize(2);
  return mesh;
}

TEST(CloseHoles, WhatIsMeantToBeOpenStaysOpen) {
  int number = 0;
  for (const Mesh& mesh : {test::open_box_mesh(dvec3(0.0), dvec3(1.0)), pipe(), sieve(),
                           holes_that_touch(), many_sided_hole(), flat_sheet(), Mesh()}) {
    Mesh after = mesh;
    after.normals.clear();
    after.normal_triangles.clear();
    EXPECT_EQ(close_holes(after).holes, 0U) << number;
    EXPECT_EQ(after.triangles, mesh.triangles) << number;
    ++number;
  }
}

TEST(CloseHoles, OnlyOfSheetsThatItCloses) {
  Mesh mesh = sphere_without({{1, 0, 0}});
  mesh.normals.clear();
  mesh.normal_triangles.clear();
  Mesh other = sieve();
  for (dvec3& position : other.positions) {
    position.x += 5.0;
  }
  append(mesh, other);
  const std::size_t edges = check_mesh(other).boundary_edges;
  EXPECT_EQ(close_holes(mesh).holes, 1U);
  EXPECT_EQ(check_mesh(mesh).boundary_edges, edges);
}

TEST(RepairMesh, DoesAllAndSaysWhat) {
  Rng rng(6, 0);
  Mesh sphere = sphere_without({{1, 0, 0}});
  sphere.triangles.erase(sphere.triangles.begin() + 700);
  Mesh mesh = as_soup(reversed(sphere), 0.2 * weld_share, rng);
  std::swap(mesh.triangles[10].x, mesh.triangles[10].y);
  EXPECT_THAT(repair(mesh), ElementsAre(::testing::StartsWith("vertices welded: "),
                                        "small holes closed: 2, by new triangles: 5",
                                        "turned 1 of 1 part outside out, turned 1 triangle to "
                                        "agree with the rest"));
  EXPECT_EQ(text_of(check_mesh(mesh)).substr(0, 47),
            "5,118 triangles in 1 part, closed, volume 4.18,");
  EXPECT_THAT(repair(mesh), IsEmpty());
}

}  // namespace
}  // namespace collage
