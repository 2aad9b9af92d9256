#include "audit/surfaces_within.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "geometry/triangle_distance.h"
#include "support/meshes.h"

namespace collage {
namespace {

Corners world_corners(const Mesh& mesh, const Instance& instance, std::size_t t) {
  return {instance.world_from_element(mesh.corner(t, 0)),
          instance.world_from_element(mesh.corner(t, 1)),
          instance.world_from_element(mesh.corner(t, 2))};
}

/// The slow twin: every triangle with every other.
double distance_by_brute_force(const Mesh& a, const Instance& instance_a, const Mesh& b,
                               const Instance& instance_b) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t s = 0; s < a.triangles.size(); ++s) {
    for (std::size_t t = 0; t < b.triangles.size(); ++t) {
      least = std::min(least, triangle_distance(world_corners(a, instance_a, s),
                                                world_corners(b, instance_b, t)));
    }
  }
  return least;
}

Instance random_instance(Rng& rng, const dvec3& at) {
  const dvec3 axis = test::random_point(rng, 1.0);
  Instance instance;
  instance.scale = 0.2 + rng.uniform();
  instance.rotation = glm::normalize(glm::dquat(0.5, axis.x, axis.y, axis.z));
  instance.translation = at + test::random_point(rng, 2.0);
  return instance;
}

TEST(SurfacesWithin, IsTrueFromTheDistanceOnThatBruteForceFinds) {
  const Mesh ring = test::torus_mesh(1.0, 0.3, 10, 6);
  const Mesh box = test::box_mesh(dvec3(3, 0, 0), dvec3(4, 0.5, 0.3));
  const SurfaceTree ring_tree(ring);
  const SurfaceTree box_tree(box);
  Rng rng(81, 0);
  int apart = 0;
  for (int i = 0; i < 100; ++i) {
    const dvec3 at(i % 2 == 0 ? 0.0 : 1e5);
    const Instance a = random_instance(rng, at);
    const Instance b = random_instance(rng, at);
    const double distance = distance_by_brute_force(ring, a, box, b);
    const double slack = i % 2 == 0 ? 1e-13 : 1e-9;
    for (const auto& within : {surfaces_within(distance + slack, ring_tree, a, box_tree, b),
                               surfaces_within(distance + slack, box_tree, b, ring_tree, a),
                               surfaces_within(2.0 * distance + slack, ring_tree, a, box_tree, b),
                               surfaces_within(100.0, ring_tree, a, box_tree, b)}) {
      EXPECT_TRUE(within);
    }
    if (distance > 0.0) {
      ++apart;
      EXPECT_FALSE(surfaces_within(distance - slack, ring_tree, a, box_tree, b));
      EXPECT_FALSE(surfaces_within(distance - slack, box_tree, b, ring_tree, a));
      EXPECT_FALSE(surfaces_within(0.5 * distance, ring_tree, a, box_tree, b));
    }
  }
  EXPECT_GT(apart, 50);
  EXPECT_LT(apart, 100);
}

TEST(SurfacesWithin, IsOfSurfacesNotOfSolids) {
  const Mesh box = test::box_mesh(dvec3(-1), dvec3(1));
  const SurfaceTree tree(box);
  Instance inner;
  inner.scale = 0.5;
  EXPECT_FALSE(surfaces_within(0.49, tree, Instance{}, tree, inner));
  EXPECT_TRUE(surfaces_within(0.5, tree, Instance{}, tree, inner));
}

}  // namespace
}  // namespace collage
