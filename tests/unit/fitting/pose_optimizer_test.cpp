#include "fitting/pose_optimizer.h"

#include <gtest/gtest.h>

#include "packing/orientation.h"
#include "unit/fitting/shape_world.h"

namespace collage {
namespace {

struct World : test::ShapeWorld {
  World() : ShapeWorld(0.3, 48) {}
};

Pose random_pose(Rng& rng, double radius) {
  const dvec3 axis = glm::normalize(test::random_point(rng, 1.0));
  return {test::random_point(rng, 0.5), orientation({0.0, 0.0, 1.0}, axis, rng.uniform()), radius};
}

void expect_same(const Pose& a, const Pose& b) {
  EXPECT_EQ(a.center, b.center);
  EXPECT_EQ(a.rotation, b.rotation);
  EXPECT_EQ(a.radius, b.radius);
}

/// From many starts, held against looking at all spheres at each step.
void expect_same_poses(PoseOptimizer& optimizer, const World& world, double first_step) {
  PoseOptimizer::Options options{.steps = 8, .first_step = first_step};
  Rng starts(1, 2);
  int found = 0;
  for (std::uint64_t i = 0; i < 40; ++i) {
    const Pose start = random_pose(starts, 0.1);
    Rng rng(3, i);
    Rng same(3, i);
    options.look = PoseOptimizer::Options::Look::at_near_ones;
    const Pose pose = optimizer.maximize(world.shape.fine(), start, options, rng);
    options.look = PoseOptimizer::Options::Look::at_all;
    expect_same(pose, optimizer.maximize(world.shape.fine(), start, options, same));
    EXPECT_TRUE(pose.radius == 0.0 || optimizer.fits(world.shape.fine(), pose));
    found += pose.radius > 0.0 ? 1 : 0;
  }
  EXPECT_GT(found, 5);
}

TEST(PoseOptimizer, FindsTheSamePosesWithoutSpheresThatAreFarAway) {
  World world;
  PoseOptimizer optimizer(world.space.distances(), 0.01);
  expect_same_poses(optimizer, world, 0.3);
  expect_same_poses(optimizer, world, 0.06);
}

/// Also where a sphere leaves a neighbour's lattice, and its distance jumps.
TEST(PoseOptimizer, FindsTheSamePosesAmongNeighbours) {
  World world;
  PoseOptimizer optimizer(world.space.distances(), 0.0);
  Rng rng(5, 6);
  for (const double radius : {0.2, 0.05}) {
    Surroundings surroundings;
    surroundings.reset(dvec3(0.0), 0.8, &world.space.target_distances());
    for (int i = 0; i < 24; ++i) {
      surroundings.add(world.shape, random_pose(rng, radius));
    }
    optimizer.look_at(&surroundings);
    expect_same_poses(optimizer, world, 0.06);
    expect_same_poses(optimizer, world, 0.3);
  }
}

}  // namespace
}  // namespace collage
