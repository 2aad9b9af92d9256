#include "fitting/free_space.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "packing/orientation.h"
#include "unit/fitting/shape_world.h"

namespace collage {
namespace {

struct World : test::ShapeWorld {
  World() : ShapeWorld(0.4, 32) {}

  [[nodiscard]] double signed_distance(const Pose& pose, const dvec3& point) const {
    const dvec3 unit = glm::conjugate(pose.rotation) * (point - pose.center) / pose.radius;
    const double distance = element.solid().surface().find(unit, 1e6)->distance * pose.radius;
    return element.solid().inside(unit) ? -distance : distance;
  }
};

std::vector<Pose> poses() {
  const glm::dquat turn = orientation({0.0, 0.0, 1.0}, glm::normalize(dvec3(1.0, 2.0, 3.0)), 0.7);
  return {{{0.1, 0.0, -0.1}, turn, 0.45}, {{-0.4, 0.3, 0.3}, glm::conjugate(turn), 0.2}};
}

/// Every lattice point, held against exact distances to the target and all instances.
TEST(FreeSpace, HoldsTheDistancesOfItsSlowTwin) {
  World world;
  const DistanceField& field = world.space.distances();
  std::uint32_t added = 0;
  for (const Pose& pose : poses()) {
    world.space.add(world.shape, pose, added++);
  }
  glm::ivec3 p;
  for (p.z = 0; p.z < field.size().z; ++p.z) {
    for (p.y = 0; p.y < field.size().y; ++p.y) {
      for (p.x = 0; p.x < field.size().x; ++p.x) {
        double expected = world.target.signed_clearance(field.point(p));
        if (expected <= 0.0) {
          continue;
        }
        for (const Pose& pose : poses()) {
          expected = std::min(expected, world.signed_distance(pose, field.point(p)));
        }
        EXPECT_NEAR(field.at(p), expected, 0.01);
      }
    }
  }
}

TEST(FreeSpace, CountsWhatInstancesTake) {
  World world;
  const Pose pose = poses().front();
  world.space.add(world.shape, pose, 0);
  const double share = static_cast<double>(world.space.points_inside_instances()) /
                       static_cast<double>(world.space.points_inside_target());
  const double volume = world.shape.unit_volume() * std::pow(pose.radius, 3.0);
  EXPECT_NEAR(share, volume / world.target.volume(), 0.01);
}

TEST(FreeSpace, ListsThePeaksThatChange) {
  World world;
  const std::vector<FreeSpace::Peak> before = world.space.peaks(0.05F);
  ASSERT_FALSE(before.empty());
  EXPECT_EQ(before.front().distance, world.space.largest_distance());
  world.space.add(world.shape, poses().front(), 0);
  const auto is_in = [](const std::vector<FreeSpace::Peak>& list, const FreeSpace::Peak& peak) {
    return std::ranges::any_of(list, [&](const FreeSpace::Peak& other) {
      return other.position == peak.position && other.distance == peak.distance;
    });
  };
  const std::vector<FreeSpace::Peak> changed = world.space.changed_peaks(0.05F);
  for (const FreeSpace::Peak& peak : world.space.peaks(0.05F)) {
    EXPECT_TRUE(is_in(before, peak) || is_in(changed, peak));
    EXPECT_EQ(world.space.climb(peak.position).position, peak.position);
  }
}

TEST(FreeSpace, KnowsWhoIsNear) {
  World world;
  std::uint32_t added = 0;
  for (const Pose& pose : poses()) {
    world.space.add(world.shape, pose, added++);
  }
  const auto near = [&](const dvec3& center, double reach, std::uint32_t wanted,
                        std::uint32_t first = 0) {
    bool found = false;
    world.space.visit_near(center, reach, first, [&](std::uint32_t i) { found |= i == wanted; });
    return found;
  };
  EXPECT_TRUE(near(poses()[0].center, 0.01, 0));
  EXPECT_TRUE(near(poses()[1].center, 0.01, 1));
  EXPECT_FALSE(near({0.8, -0.6, -0.6}, 0.01, 1));
  EXPECT_TRUE(near(poses()[1].center, 0.01, 1, 1));
  EXPECT_FALSE(near(poses()[0].center, 0.01, 0, 1));
}

TEST(FreeSpace, KnowsAnInstanceWhereItsSolidIs) {
  World world;
  FreeSpace space(world.target, 96, world.status);
  const Pose pose{{0.1, 0.0, -0.1}, poses()[0].rotation, 0.65};
  space.add(world.shape, pose, 0);
  Rng rng(1, 2);
  int inside = 0;
  int unknown = 0;
  for (int i = 0; i < 5000; ++i) {
    const dvec3 point = pose.center + test::random_point(rng, pose.radius);
    bool known = false;
    space.visit_near(point, 1e-6, 0, [&](std::uint32_t) { known = true; });
    const bool solid = world.signed_distance(pose, point) <= 0.0;
    EXPECT_TRUE(known || !solid);
    inside += solid ? 1 : 0;
    unknown += known ? 0 : 1;
  }
  EXPECT_GT(inside, 100);
  EXPECT_GT(unknown, 100);  // its bounding box is not all that is listed
}

/// The sign of an open box changes in its opening, far from any surface.
TEST(DistanceField, PutsASurfaceIntoGaps) {
  const Mesh mesh = test::open_box_mesh(dvec3(-1.0), dvec3(1.0));
  const MeshTarget target(mesh);
  Status status;
  const FreeSpace space(target, 24, status);
  const DistanceField& field = space.distances();
  glm::ivec3 p;
  for (p.z = 0; p.z < field.size().z; ++p.z) {
    for (p.y = 0; p.y < field.size().y; ++p.y) {
      for (p.x = 0; p.x + 1 < field.size().x; ++p.x) {
        const double change = std::abs(field.at(p + glm::ivec3(1, 0, 0)) - field.at(p));
        EXPECT_LE(change, 1.001 * field.spacing());
      }
    }
  }
  glm::vec3 direction;
  field.value(glm::vec3(field.steps({0.0, 0.9, 0.0})), direction);
  EXPECT_LT(direction.y, -0.9F);
}

}  // namespace
}  // namespace collage
