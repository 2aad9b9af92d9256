#include "geometry/solid.h"

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace collage {
namespace {

Solid solid_of(const Mesh& mesh) {
  const Box box = bounding_box(mesh);
  return {mesh, box.center(), 0.5 * glm::length(box.extent())};
}

TEST(Solid, InsideAgreesWithTheWindingNumberEverywhere) {
  for (const Mesh& mesh : {test::torus_mesh(1.0, 0.1, 40, 12), test::blob_mesh(1.0, 0.4, 20),
                           test::open_box_mesh(dvec3(-1), dvec3(1))}) {
    const Solid solid = solid_of(mesh);
    Rng rng(5, 0);
    int inside = 0;
    for (int i = 0; i < 20000; ++i) {
      const dvec3 point = test::random_point(rng, 1.2);
      ASSERT_EQ(solid.inside(point), solid.inside_by_winding_number(point))
          << point.x << " " << point.y;
      inside += solid.inside(point) ? 1 : 0;
    }
    EXPECT_GT(inside, 50);
  }
}

TEST(Solid, WhatACellTellsHoldsForPointsThatAreALittleOff) {
  for (const Mesh& mesh : {test::torus_mesh(1.0, 0.1, 40, 12), test::blob_mesh(1.0, 0.4, 20),
                           test::open_box_mesh(dvec3(-1), dvec3(1))}) {
    const Solid solid = solid_of(mesh);
    Rng rng(6, 0);
    int told = 0;
    for (int i = 0; i < 20000; ++i) {
      const dvec3 point = test::random_point(rng, 0.57);
      if (const auto inside = solid.inside_by_cell(glm::vec3(point))) {
        const dvec3 off = test::random_point(rng, Solid::cell_margin / 2);
        ASSERT_EQ(*inside, solid.inside_by_winding_number(point + off));
        ++told;
      }
    }
    EXPECT_GT(told, 4000);
  }
}

TEST(Solid, VolumeOfAClosedMeshIsExactWhereverItStandsAndHoweverLarge) {
  for (const double size : {1e-5, 1.0, 1e5}) {
    for (const double offset : {0.0, 1e3}) {
      const dvec3 corner(offset * size);
      const Mesh mesh = test::box_mesh(corner, corner + size * dvec3(1, 2, 3));
      EXPECT_NEAR(solid_of(mesh).volume() / (6.0 * size * size * size), 1.0, 1e-9);
    }
  }
}

TEST(Solid, VolumeOfPartsThatPassThroughEachOtherCountsOnce) {
  Mesh mesh = test::box_mesh(dvec3(0), dvec3(2, 1, 1));
  const Mesh other = test::box_mesh(dvec3(1, 0.1, 0.1), dvec3(3, 0.9, 0.9));
  for (const uvec3& t : other.triangles) {
    mesh.triangles.push_back(t + 8U);
  }
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  EXPECT_NEAR(enclosed_volume(mesh), 2.0 + 1.28, 1e-9);
  EXPECT_NEAR(solid_of(mesh).volume(), 2.0 + 0.64, 0.02);
}

TEST(Solid, VolumeOfAnOpenMeshIsThatOfWhatItHolds) {
  // A tube of 1 × 4 × 1 without one end: the winding number closes it by a shallow dome.
  const Mesh mesh = test::open_box_mesh(dvec3(0), dvec3(1, 4, 1));
  EXPECT_NEAR(solid_of(mesh).volume(), 4.0, 0.3);
}

}  // namespace
}  // namespace collage
