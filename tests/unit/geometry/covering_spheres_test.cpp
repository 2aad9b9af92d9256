#include "geometry/covering_spheres.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "geometry/surface_points.h"
#include "support/meshes.h"

namespace collage {
namespace {

struct Covered {
  explicit Covered(const Mesh& mesh)
      : ball(smallest_enclosing_sphere(mesh.positions)),
        unit_mesh(in_unit_frame(mesh, ball.center, ball.radius)),
        solid(mesh, ball.center, ball.radius),
        coverer(solid, unit_mesh) {}

  Sphere ball;
  Mesh unit_mesh;
  Solid solid;
  SphereCoverer coverer;
};

/// How far a point is from the union of the spheres; negative inside.
double outside_by(const SphereCover& cover, const dvec3& point) {
  double least = 1e300;
  for (const Sphere& sphere : cover.spheres) {
    least = std::min(least, glm::distance(point, sphere.center) - sphere.radius);
  }
  return least;
}

std::vector<Mesh> shapes() {
  Mesh inside_out = test::blob_mesh(1.0, 0.2, 12);
  reverse_orientation(inside_out);
  return {test::torus_mesh(1.0, 0.25, 32, 12), test::blob_mesh(1.0, 0.4, 16),
          test::box_mesh({-1.0, -0.1, -0.5}, {1.0, 0.1, 0.5}),
          test::open_box_mesh({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}), inside_out};
}

/// Points that the coverer has not seen; between its samples they may stick out a little.
TEST(CoveringSpheres, HoldTheSolid) {
  for (const Mesh& mesh : shapes()) {
    const Covered covered(mesh);
    for (const std::size_t count : {32U, 200U}) {
      const SphereCover cover = covered.coverer.cover(count);
      ASSERT_LE(cover.spheres.size(), count);
      double worst = -1.0;
      for (const SurfacePoint& point : spread_over_surface(covered.unit_mesh, 5000)) {
        worst = std::max(worst, outside_by(cover, point.position));
      }
      for (const dvec3& vertex : covered.unit_mesh.positions) {
        EXPECT_LE(outside_by(cover, vertex), 1e-9);
      }
      Rng rng(1, 0);
      for (int i = 0; i < 5000; ++i) {
        const double x = rng.uniform();
        const double y = rng.uniform();
        const dvec3 point = 2.0 * dvec3(x, y, rng.uniform()) - 1.0;
        if (covered.solid.inside(point)) {
          worst = std::max(worst, outside_by(cover, point));
        }
      }
      EXPECT_LT(worst, 0.02);
    }
  }
}

TEST(CoveringSpheres, ReachBeyondTheSolidByTheBulgeAtMost) {
  for (const Mesh& mesh : shapes()) {
    const Covered covered(mesh);
    const SphereCover cover = covered.coverer.cover(100);
    for (const Sphere& sphere : cover.spheres) {
      const double depth = covered.solid.inside(sphere.center)
                               ? covered.solid.surface().find(sphere.center, 10.0)->distance
                               : 0.0;
      EXPECT_LE(sphere.radius, depth + cover.bulge + 1e-6);
    }
  }
}

TEST(CoveringSpheres, MoreSpheresBulgeLess) {
  const Covered covered(test::torus_mesh(1.0, 0.25, 32, 12));
  const double few = covered.coverer.cover(30).bulge;
  const double many = covered.coverer.cover(120).bulge;
  const double most = covered.coverer.cover(480).bulge;
  EXPECT_LT(many, 0.6 * few);
  EXPECT_LT(most, 0.75 * many);
}

TEST(CoveringSpheres, OneSphereIsTheEnclosingOne) {
  const Covered covered(test::torus_mesh(1.0, 0.25, 32, 12));
  const SphereCover cover = covered.coverer.cover(1);
  ASSERT_EQ(cover.spheres.size(), 1U);
  EXPECT_EQ(cover.spheres[0].center, dvec3(0.0));
  EXPECT_EQ(cover.spheres[0].radius, 1.0);
}

}  // namespace
}  // namespace collage
