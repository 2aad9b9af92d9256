#include "fitting/collision_shape.h"

#include <gtest/gtest.h>

#include "geometry/triangle_distance.h"
#include "packing/element.h"
#include "packing/orientation.h"
#include "support/meshes.h"

namespace collage {
namespace {

struct Body {
  explicit Body(Mesh of) : mesh(std::move(of)) {}

  Mesh mesh;
  Element element{mesh};
  CollisionShape shape{mesh, element.solid()};
};

Corners corners(const Mesh& mesh, std::size_t triangle, const Instance& instance) {
  return {instance.world_from_element(mesh.corner(triangle, 0)),
          instance.world_from_element(mesh.corner(triangle, 1)),
          instance.world_from_element(mesh.corner(triangle, 2))};
}

/// Each triangle with each.
bool slow_twin(double gap, const Mesh& a, const Instance& instance_a, const Mesh& b,
               const Instance& instance_b) {
  for (std::size_t s = 0; s < a.triangles.size(); ++s) {
    for (std::size_t t = 0; t < b.triangles.size(); ++t) {
      if (triangle_distance(corners(a, s, instance_a), corners(b, t, instance_b)) <= gap) {
        return true;
      }
    }
  }
  return false;
}

Instance random_instance(Rng& rng, const dvec3& from) {
  const dvec3 axis = glm::normalize(test::random_point(rng, 1.0));
  Instance instance;
  instance.scale = 0.3 + rng.uniform();
  instance.rotation = orientation({0.0, 0.0, 1.0}, axis, 6.0 * rng.uniform());
  instance.translation = from + test::random_point(rng, 1.4);
  return instance;
}

TEST(CollisionShape, ComesWithinAGapWhereATriangleDoes) {
  const Body ring(test::torus_mesh(1.0, 0.3, 10, 6));
  const Body box(test::box_mesh(dvec3(-0.9, -0.05, -0.4), dvec3(0.9, 0.05, 0.4)));
  Rng rng(7, 8);
  int met = 0;
  int apart = 0;
  for (int i = 0; i < 300; ++i) {
    const dvec3 from = i % 3 == 0 ? dvec3(3e4, -2e4, 1e4) : dvec3(0.0);
    const Instance a = random_instance(rng, from);
    const Instance b = random_instance(rng, from);
    const double gap = i % 2 == 0 ? 0.0 : 0.2 * rng.uniform();
    const Body& second = i % 5 == 0 ? ring : box;
    const bool expected = slow_twin(gap, ring.mesh, a, second.mesh, b);
    EXPECT_EQ(surfaces_come_within(gap, ring.shape, a, second.shape, b), expected) << i;
    EXPECT_EQ(surfaces_come_within(gap, second.shape, b, ring.shape, a), expected) << i;
    (expected ? met : apart) += 1;
  }
  EXPECT_GT(met, 50);
  EXPECT_GT(apart, 50);
}

/// Faces that lie in one plane have no plane between them.
TEST(CollisionShape, TouchingIsMeeting) {
  const Body box(test::box_mesh(dvec3(0.0), dvec3(1.0)));
  Instance beside;
  beside.translation = dvec3(1.0, 0.25, 0.25);
  EXPECT_TRUE(surfaces_come_within(0.0, box.shape, Instance{}, box.shape, beside));
  beside.translation.x = 1.0 + 1e-15;
  EXPECT_FALSE(surfaces_come_within(0.0, box.shape, Instance{}, box.shape, beside));
  beside.translation = dvec3(1.0);  // by a corner
  EXPECT_TRUE(surfaces_come_within(0.0, box.shape, Instance{}, box.shape, beside));
}

}  // namespace
}  // namespace collage
