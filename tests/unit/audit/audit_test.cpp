#include "audit/audit.h"

#include <gtest/gtest.h>

#include "geometry/mesh_parts.h"
#include "packing/pack.h"
#include "support/meshes.h"

namespace collage {
namespace {

/// A packing that is right, and what the audit says after one thing in it was changed.
class AuditTest : public testing::Test {
 protected:
  AuditTest() {
    Status status;
    const MeshTarget target(target_mesh_);
    const Element element(ring_);
    const std::vector<Ingredient> ingredients{{element, {1.0}, 1.0}};
    PackingOptions options;
    options.scaling = Scaling::to_hole;
    options.threshold = 0.06;
    ClearanceField field(target, target.voxels(30, 0.5, 1), status);
    instances_ = pack(target, field, ingredients, options, status).instances;
  }

  Audit look() {
    Status status;
    AuditInput input;
    input.target = &target_mesh_;
    input.elements = {&ring_};
    input.scales = {scales_};
    input.instances = instances_;
    return audit(input, status);
  }

  Mesh target_mesh_ = test::blob_mesh(1.0, 0.2, 16);
  Mesh ring_ = test::torus_mesh(1.0, 0.4, 16, 8);
  std::vector<double> scales_;
  std::vector<Instance> instances_;
};

TEST_F(AuditTest, PassesWhatThePackerMade) {
  ASSERT_GT(instances_.size(), 30U);
  EXPECT_TRUE(look().passed());
}

TEST_F(AuditTest, FindsAnInstanceMovedIntoItsNeighbour) {
  // Towards the neighbour until they meet, by bisection; then 1e-4 of the longest side farther.
  const Instance free = instances_[1];
  const dvec3 way = instances_[0].translation - free.translation;
  double apart = 0.0;
  double meeting = 1.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (apart + meeting);
    instances_[1].translation = free.translation + middle * way;
    const auto& overlaps = look().overlaps;
    const bool meet = !overlaps.empty() && overlaps[0].first == 0 && overlaps[0].second == 1;
    (meet ? meeting : apart) = middle;
  }
  instances_[1].translation = free.translation + (meeting + 2e-4 / glm::length(way)) * way;
  const Audit result = look();
  ASSERT_FALSE(result.overlaps.empty());
  EXPECT_EQ(result.overlaps[0].first, 0U);
  EXPECT_EQ(result.overlaps[0].second, 1U);
  EXPECT_GT(result.overlaps[0].depth.value(), 0.0);
  EXPECT_LE(result.overlaps[0].depth.value(), 2e-4);
}

TEST_F(AuditTest, FindsAnInstancePutInsideAnothersWall) {
  instances_.resize(1);
  Instance inside = instances_[0];
  inside.scale *= 0.05;
  const dvec3 in_wall = instances_[0].world_from_element({1.0, 0.0, 0.0});
  inside.translation = in_wall;
  instances_.push_back(inside);
  EXPECT_EQ(look().overlaps.size(), 1U);
  std::swap(instances_[0], instances_[1]);
  EXPECT_EQ(look().overlaps.size(), 1U);
}

TEST_F(AuditTest, LetsARingStandInTheHoleOfAnother) {
  instances_.resize(1);
  Instance within = instances_[0];
  within.scale *= 0.3;
  instances_.push_back(within);
  EXPECT_TRUE(look().overlaps.empty());
}

TEST_F(AuditTest, FindsTheSameInstanceTwice) {
  instances_.push_back(instances_[0]);
  EXPECT_EQ(look().overlaps.size(), 1U);
}

TEST_F(AuditTest, FindsAnInstancePushedOut) {
  instances_[0].translation += dvec3(0.9, 0, 0);
  EXPECT_EQ(look().protrusions.front(), 0U);
  instances_[0].translation += dvec3(9, 0, 0);  // all of it outside, without touching the surface
  EXPECT_EQ(look().protrusions.front(), 0U);
}

TEST_F(AuditTest, FindsScaledAndShearedInstances) {
  scales_ = {0.5};
  instances_.resize(1);
  instances_[0].scale = 0.5;
  EXPECT_TRUE(look().deformed.empty());
  instances_[0].scale = 0.5000001;
  EXPECT_EQ(look().deformed.size(), 1U);
  instances_[0].scale = 0.5;
  instances_[0].rotation *= 1.0 + 1e-8;
  EXPECT_EQ(look().deformed.size(), 1U);
}

TEST_F(AuditTest, LetsAnInstanceStandInTheOpeningOfAnotherButNotInside) {
  const Mesh room = test::box_mesh(dvec3(-9), dvec3(9));
  const Mesh bowl = test::open_box_mesh(dvec3(-1), dvec3(1));
  const auto overlaps = [&](double height) {
    std::vector<Instance> two(2);
    two[1].scale = 0.3;
    two[1].translation.y = height;
    Status status;
    return audit({&room, {&bowl}, {{}}, two}, status).overlaps.size();
  };
  EXPECT_EQ(overlaps(1.5), 0U);
  EXPECT_EQ(overlaps(1.0), 0U);
  EXPECT_EQ(overlaps(0.0), 1U);
}

TEST_F(AuditTest, CountsTwoPartsInTheOpeningOfAnotherAsOne) {
  const Mesh room = test::box_mesh(dvec3(-9), dvec3(9));
  const Mesh bowl = test::open_box_mesh(dvec3(-1), dvec3(1));
  const auto overlaps = [&](double height) {
    Mesh dumbbell = test::box_mesh(dvec3(-0.1), dvec3(0.1));
    const dvec3 above(0.0, height, 0.0);
    append_part(dumbbell, test::box_mesh(above - 0.1, above + 0.1), Material());
    std::vector<Instance> two(2);
    two[1].element = 1;
    Status status;
    return audit({&room, {&bowl, &dumbbell}, {{}, {}}, two}, status).overlaps.size();
  };
  EXPECT_EQ(overlaps(3.0), 0U);
  EXPECT_EQ(overlaps(0.3), 1U);
}

TEST_F(AuditTest, LetsAnInstanceStandInTheOpeningOfTheTargetButNotOutside) {
  target_mesh_ = test::open_box_mesh(dvec3(-3), dvec3(3));
  instances_.assign(1, Instance{});
  EXPECT_TRUE(look().passed());
  instances_[0].translation.y = 3.0;
  EXPECT_TRUE(look().passed());
  instances_[0].translation.y = 5.0;
  EXPECT_EQ(look().protrusions.size(), 1U);
}

TEST_F(AuditTest, FindsANeighbourThatTouchesInOnePointOnly) {
  const Mesh box = test::box_mesh(dvec3(0), dvec3(1));
  const Mesh room = test::box_mesh(dvec3(-9), dvec3(9));
  std::vector<Instance> two(2);
  two[1].translation = dvec3(1, 1, 1);
  Status status;
  const AuditInput input{&room, {&box}, {{}}, two};
  EXPECT_EQ(audit(input, status).overlaps.size(), 1U);
  two[1].translation = dvec3(std::nextafter(1.0, 2.0), 1, 1);
  EXPECT_TRUE(audit(input, status).overlaps.empty());
}

}  // namespace
}  // namespace collage
