#include "audit/penetration.h"

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace collage {
namespace {

double depth(const Mesh& a, const Instance& at_a, const Mesh& b, const Instance& at_b) {
  return penetration_depth(AuditShape(a), at_a, AuditShape(b), at_b);
}

TEST(PenetrationDepth, IsHowFarACornerReachesIn) {
  const Mesh box = test::box_mesh(dvec3(0), dvec3(1));
  Instance moved;
  moved.translation = dvec3(1.0 - 1e-4, 0.3, 0.4);
  EXPECT_NEAR(depth(box, {}, box, moved), 1e-4, 1e-15);
  EXPECT_NEAR(depth(box, moved, box, {}), 1e-4, 1e-15);
}

TEST(PenetrationDepth, IsSeenWhereOnlyEdgesRunThrough) {
  const Mesh beam = test::box_mesh(dvec3(-2, -0.3, -0.3), dvec3(2, 0.3, 0.3));
  const Mesh post = test::box_mesh(dvec3(-0.5, -0.5, -2), dvec3(0.5, 0.5, 2));
  EXPECT_NEAR(depth(beam, {}, post, {}), 0.5, 1e-12);  // at the middle of its sides' diagonals
}

TEST(PenetrationDepth, IsInWorldUnits) {
  const Mesh box = test::box_mesh(dvec3(-1), dvec3(1));
  Instance large;
  large.scale = 10.0;
  large.rotation = glm::angleAxis(0.7, glm::normalize(dvec3(1, 2, 3)));
  large.translation = dvec3(5, 6, 7);
  Instance small = large;
  small.scale = 1.0;
  EXPECT_NEAR(depth(box, large, box, small), 9.0, 1e-12);
}

TEST(PenetrationDepth, OfTwoThatTouchIsNothing) {
  const Mesh box = test::box_mesh(dvec3(0), dvec3(1));
  Instance beside;
  beside.translation = dvec3(1, 0, 0);
  EXPECT_EQ(depth(box, {}, box, beside), 0.0);
}

}  // namespace
}  // namespace collage
