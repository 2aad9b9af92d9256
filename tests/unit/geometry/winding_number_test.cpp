#include "geometry/winding_number.h"

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace collage {
namespace {

TEST(WindingNumberExact, IsOneInsideAndZeroOutsideOfAClosedMesh) {
  const Mesh mesh = test::torus_mesh(1.0, 0.3, 20, 10);
  EXPECT_NEAR(winding_number(mesh, {1.0, 0.0, 0.0}), 1.0, 1e-12);
  EXPECT_NEAR(winding_number(mesh, {0.0, 0.0, 0.0}), 0.0, 1e-12);
  EXPECT_NEAR(winding_number(mesh, {0.0, 5.0, 0.0}), 0.0, 1e-12);
}

TEST(WindingNumberExact, IsMinusOneInsideAMeshTurnedInsideOut) {
  Mesh mesh = test::box_mesh(dvec3(-1), dvec3(1));
  reverse_orientation(mesh);
  EXPECT_NEAR(winding_number(mesh, dvec3(0.1)), -1.0, 1e-12);
}

TEST(WindingNumberExact, FallsBySixthsAsACubeLosesFaces) {
  const Mesh open = test::open_box_mesh(dvec3(-1), dvec3(1));
  EXPECT_NEAR(winding_number(open, dvec3(0.0)), 5.0 / 6.0, 1e-12);
}

TEST(WindingNumber, AgreesWithItsSlowTwin) {
  for (const Mesh& mesh : {test::torus_mesh(1.0, 0.3, 64, 32), test::blob_mesh(1.0, 0.4, 40),
                           test::open_box_mesh(dvec3(-1), dvec3(1))}) {
    const WindingNumber fast(mesh);
    Rng rng(3, 0);
    double worst = 0.0;
    for (int i = 0; i < 2000; ++i) {
      const dvec3 point = test::random_point(rng, 2.0);
      worst = std::max(worst, std::abs(fast.at(point) - winding_number(mesh, point)));
    }
    EXPECT_LT(worst, 0.04);
  }
}

TEST(WindingNumber, OfNothingIsZero) { EXPECT_EQ(WindingNumber(Mesh{}).at({0, 0, 0}), 0.0); }

}  // namespace
}  // namespace collage
