#include "audit/largest_hole.h"

#include <array>

#include <gtest/gtest.h>

#include "base/rng.h"
#include "support/meshes.h"

namespace collage {
namespace {

struct Scene {
  Mesh target;
  Mesh element;
  std::vector<Instance> instances;

  [[nodiscard]] LargestHole hole() const {
    const std::array elements{&element};
    const InstanceIndex index(elements, instances);
    Status status;
    return find_largest_hole(TargetShape(target), index, status);
  }
};

Instance at(const dvec3& translation, double scale) {
  Instance instance;
  instance.translation = translation;
  instance.scale = scale;
  return instance;
}

TEST(LargestHole, OfAnEmptyBoxIsItsInscribedBall) {
  const Scene scene{
      test::box_mesh(dvec3(0), dvec3(1, 2, 4)), test::box_mesh(dvec3(-1), dvec3(1)), {}};
  const LargestHole hole = scene.hole();
  EXPECT_NEAR(hole.radius, 0.5, 1e-4);
  EXPECT_GE(hole.bound, 0.5);
  EXPECT_LE(hole.bound, 0.5 * 1.011);
  EXPECT_TRUE(hole.proven);
}

TEST(LargestHole, LiesBesideTheInstances) {
  // A box of 4 with a box of 2 in its corner: the ball in the corner across touches three walls and
  // the inner box's corner, |(4 - r) (1,1,1) - (2,2,2)| = r.
  const Scene scene{test::box_mesh(dvec3(0), dvec3(4)),
                    test::box_mesh(dvec3(0), dvec3(1)),
                    {at(dvec3(0.01), 1.99)}};
  const LargestHole hole = scene.hole();
  const double side = std::sqrt(3.0) * 2.0 / (1.0 + std::sqrt(3.0));
  EXPECT_LE(hole.radius, side);
  EXPECT_GE(hole.radius, 0.99 * side);
  EXPECT_GE(hole.bound, side);
  EXPECT_NEAR(glm::distance(hole.center, dvec3(4.0 - side)), 0.0, 0.05);
}

TEST(LargestHole, IsNotLookedForInsideOfInstances) {
  // Filled but for a gap of 0.1 all round: what is free is no thicker.
  const Scene scene{test::box_mesh(dvec3(-1), dvec3(1)),
                    test::box_mesh(dvec3(-1), dvec3(1)),
                    {at(dvec3(0), 0.9)}};
  const LargestHole hole = scene.hole();
  // In the corner: √3 (0.1 - r) = r.
  const double corner = std::sqrt(3.0) * 0.1 / (1.0 + std::sqrt(3.0));
  EXPECT_NEAR(hole.radius, corner, 1e-4);
  EXPECT_GE(hole.bound, corner);
  EXPECT_LE(hole.bound, corner * 1.02);
}

TEST(LargestHole, IsZeroWhereNothingIsFree) {
  const Scene scene{test::box_mesh(dvec3(-1), dvec3(1)),
                    test::box_mesh(dvec3(-1), dvec3(1)),
                    {at(dvec3(0), 1.0)}};
  const LargestHole hole = scene.hole();
  EXPECT_EQ(hole.radius, 0.0);
  EXPECT_LE(hole.bound, 0.0021);
}

/// The slow twin: no point of a fine random sample has more clearance than the bound.
TEST(LargestHole, IsAboveAllThatASampleFinds) {
  Rng rng(1, 1);
  Scene scene{test::blob_mesh(1.0, 0.2, 16), test::torus_mesh(1.0, 0.4, 16, 8), {}};
  for (int i = 0; i < 60; ++i) {
    scene.instances.push_back(at(test::random_point(rng, 0.8), 0.05 + 0.1 * rng.uniform()));
  }
  const LargestHole hole = scene.hole();
  const std::array elements{&scene.element};
  const InstanceIndex index(elements, scene.instances);
  const Solid solid(scene.target, dvec3(0), 2.0);
  double best = 0.0;
  for (int i = 0; i < 200000; ++i) {
    const dvec3 point = test::random_point(rng, 1.2);
    const dvec3 unit = solid.unit_from_mesh(point);
    if (!solid.inside(unit) || index.holder(point)) {
      continue;
    }
    const double wall = solid.surface().find(unit, 10.0)->distance * solid.radius();
    best = std::max(best, std::min(wall, index.nearest(point, 10.0)->distance));
  }
  EXPECT_GE(hole.bound, best);
  EXPECT_GE(hole.radius, 0.98 * best);
  EXPECT_LE(hole.bound, 1.011 * hole.radius);
}

TEST(LargestHole, ComesToAnEndBesideAnEnormousInstance) {
  const Scene scene{test::box_mesh(dvec3(0), dvec3(1)),
                    test::box_mesh(dvec3(-1), dvec3(1)),
                    {at(dvec3(0.5 - 1e7, 0, 0), 1e7)}};
  const LargestHole hole = scene.hole();
  EXPECT_LE(hole.radius, 0.25);
  EXPECT_FALSE(hole.proven);
}

TEST(LargestHole, OfAnOpenMeshIsSaidToBeUnproven) {
  const Scene scene{test::open_box_mesh(dvec3(0), dvec3(1, 1, 1)),
                    test::box_mesh(dvec3(-1), dvec3(1)),
                    {at(dvec3(0.5, 0.3, 0.5), 0.05)}};
  const LargestHole hole = scene.hole();
  EXPECT_FALSE(hole.proven);
  EXPECT_GT(hole.radius, 0.3);
}

}  // namespace
}  // namespace collage
