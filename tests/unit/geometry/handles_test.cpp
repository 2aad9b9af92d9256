#include "geometry/handles.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "geometry/polyhedra.h"
#include "mesh_quality.h"

namespace collage {
namespace {

TEST(Handles, EachAddsOneToTheGenus) {
  const PolygonMesh cube = regular_cube();
  const std::array<FacePair, 2> pairs = {
      {{face_towards(cube, {1, 0, 0}), face_towards(cube, {0, 1, 0})},
       {face_towards(cube, {-1, 0, 0}), face_towards(cube, {0, -1, 0})}}};
  for (int count = 1; count <= 2; ++count) {
    const PolygonMesh mesh =
        with_handles(cube, std::span(pairs).first(count), {.steps = 5, .reach = 2.0, .waist = 0.5});
    EXPECT_EQ(mesh.faces.size(), 6U + 18U * count);
    EXPECT_EQ(euler_characteristic(mesh), 2 - 2 * count);
    EXPECT_TRUE(is_closed_outward(mesh));
    EXPECT_GT(enclosed_volume(triangulated(mesh)), enclosed_volume(triangulated(cube)));
    EXPECT_EQ(self_intersections(triangulated(mesh)), 0U);
  }
}

TEST(Handles, ANegativeReachBoresATunnel) {
  PolygonMesh cube = regular_cube();
  const std::array<FacePair, 1> pairs = {
      {{face_towards(cube, {0, 1, 0}), face_towards(cube, {0, -1, 0})}}};
  for (const FacePair& pair : pairs) {
    for (const std::uint32_t face : {pair.from, pair.to}) {
      const dvec3 middle = face_middle(cube, face);
      std::vector<dvec3> smaller;
      for (const std::uint32_t corner : cube.faces[face]) {
        smaller.push_back(0.5 * (middle + cube.positions[corner]));
      }
      raise_face(cube, face, smaller);
    }
  }
  const PolygonMesh mesh = with_handles(cube, pairs, {.steps = 3, .reach = -0.3});
  EXPECT_EQ(euler_characteristic(mesh), 0);
  EXPECT_TRUE(is_closed_outward(mesh));
  EXPECT_NEAR(enclosed_volume(triangulated(mesh)), 0.75 * enclosed_volume(triangulated(cube)),
              1e-5);
}

TEST(Handles, GoStraightUnlessTwisted) {
  PolygonMesh two = regular_cube();
  PolygonMesh other = regular_cube();
  for (PolygonMesh::Face& face : other.faces) {
    for (std::uint32_t& corner : face) {
      corner += 8;
    }
  }
  for (const dvec3& position : regular_cube().positions) {
    two.positions.push_back(position + dvec3(4, 0, 0));
  }
  two.faces.insert(two.faces.end(), other.faces.begin(), other.faces.end());
  const std::uint32_t right = face_towards(regular_cube(), {1, 0, 0});
  const std::uint32_t left = 6 + face_towards(regular_cube(), {-1, 0, 0});
  const std::array<FacePair, 1> pairs = {{{right, left}}};
  const double bar = std::pow(2.0 * std::sqrt(1.0 / 3.0), 2.0) * 4.0;
  const double cube = enclosed_volume(triangulated(regular_cube()));
  const PolygonMesh straight = with_handles(two, pairs, {.steps = 4, .reach = 1.0});
  EXPECT_EQ(euler_characteristic(straight), 2);  // two parts become one
  EXPECT_NEAR(enclosed_volume(triangulated(straight)), cube + bar, 1e-5);

  // Half-way, a square that is turned by one corner in all is turned by 45°.
  for (const int twist : {-1, 0, 1}) {
    const PolygonMesh mesh = with_handles(two, pairs, {.steps = 2, .reach = 1.0, .twist = twist});
    EXPECT_TRUE(is_closed_outward(mesh));
    std::size_t half_way = 0;
    for (const dvec3& p : mesh.positions) {
      if (std::abs(p.x - 2.0) < 1e-9) {
        ++half_way;
        const double nearest = std::min(std::abs(p.y), std::abs(p.z));
        EXPECT_NEAR(nearest, twist == 0 ? std::sqrt(1.0 / 3.0) : 0.0, 1e-9);
      }
    }
    EXPECT_EQ(half_way, 4U);
  }
}

}  // namespace
}  // namespace collage
