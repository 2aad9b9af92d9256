#include "audit/instance_index.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "audit/audit_shape.h"
#include "support/meshes.h"

namespace collage {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

glm::dquat random_rotation(Rng& rng) {
  glm::dquat q(0.0, 0.0, 0.0, 0.0);
  do {
    const dvec3 v = test::random_point(rng, 1.0);
    q = {2.0 * rng.uniform() - 1.0, v.x, v.y, v.z};
  } while (glm::dot(q, q) > 1.0 || glm::dot(q, q) < 0.01);
  return glm::normalize(q);
}

/// Two meshes in three elements, the third the first again, scattered in a box of side 2 at `at`.
class InstanceIndexTest : public testing::Test {
 protected:
  void scatter(std::size_t count, const dvec3& at) {
    Rng rng(3, count);
    center_ = at;
    instances_.clear();
    for (std::size_t i = 0; i < count; ++i) {
      Instance instance;
      instance.element = static_cast<std::uint32_t>(rng.below(3));
      instance.scale = 0.02 + 0.1 * rng.uniform();
      instance.rotation = random_rotation(rng);
      instance.translation = at + test::random_point(rng, 1.0);
      instances_.push_back(instance);
    }
  }

  [[nodiscard]] InstanceIndex index() const { return {elements_, instances_}; }

  /// The slow twin: every triangle of every instance.
  [[nodiscard]] double brute_force_distance(const dvec3& point) const {
    double best = unbounded;
    for (const Instance& instance : instances_) {
      const Mesh& mesh = *elements_[instance.element];
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const dvec3 closest =
            closest_point_on_triangle(point, instance.world_from_element(mesh.corner(t, 0)),
                                      instance.world_from_element(mesh.corner(t, 1)),
                                      instance.world_from_element(mesh.corner(t, 2)));
        best = std::min(best, glm::distance(point, closest));
      }
    }
    return best;
  }

  /// The slow twin: the exact winding number of every instance.
  [[nodiscard]] std::optional<std::uint32_t> brute_force_holder(const dvec3& point) const {
    for (std::uint32_t i = 0; i < instances_.size(); ++i) {
      const dvec3 p = instances_[i].element_from_world(point);
      if (winding_number(*elements_[instances_[i].element], p) > 0.5) {
        return i;
      }
    }
    return std::nullopt;
  }

  Mesh ring_ = test::torus_mesh(1.0, 0.4, 12, 6);
  /// Far from its own origin.
  Mesh box_ = test::box_mesh(dvec3(5.0, 0.0, 0.0), dvec3(6.0, 0.5, 0.3));
  std::vector<const Mesh*> elements_{&ring_, &box_, &ring_};
  std::vector<Instance> instances_;
  dvec3 center_{0.0};
};

TEST_F(InstanceIndexTest, NearestAgreesWithBruteForceWhereverTheInstancesAre) {
  for (const double offset : {0.0, 1e4}) {
    scatter(150, dvec3(offset, 0.0, -offset));
    const InstanceIndex index = this->index();
    Rng rng(4, 0);
    for (int i = 0; i < 300; ++i) {
      const dvec3 point = center_ + test::random_point(rng, 1.5);
      const double truth = brute_force_distance(point);
      const auto found = index.nearest(point, unbounded);
      ASSERT_TRUE(found);
      EXPECT_LE(truth, found->distance + 1e-14 * offset + 1e-15);
      EXPECT_GE(truth, found->distance - found->error);
      EXPECT_LT(found->error, 1e-5);
    }
  }
}

TEST_F(InstanceIndexTest, NearestNamesTheInstanceWhoseDistanceItGives) {
  scatter(60, dvec3(0.0));
  const std::vector<Instance> all = instances_;
  const InstanceIndex index(elements_, all);
  Rng rng(5, 0);
  for (int i = 0; i < 100; ++i) {
    const dvec3 point = test::random_point(rng, 1.5);
    const auto found = index.nearest(point, unbounded);
    ASSERT_TRUE(found);
    instances_ = {all[found->instance]};
    EXPECT_NEAR(brute_force_distance(point), found->distance, 1e-12);
  }
}

TEST_F(InstanceIndexTest, NearestFindsNothingBeyondTheGivenDistance) {
  scatter(20, dvec3(0.0));
  const InstanceIndex index = this->index();
  const dvec3 point(3.0, 0.0, 0.0);
  const double distance = index.nearest(point, unbounded)->distance;
  EXPECT_FALSE(index.nearest(point, distance * 0.9999));
  EXPECT_TRUE(index.nearest(point, distance * 1.0001));
}

TEST_F(InstanceIndexTest, HolderIsTheFirstInstanceAroundThePoint) {
  scatter(400, dvec3(0.0));
  for (Instance& instance : instances_) {
    instance.scale *= 2.0;  // so that many overlap
  }
  const InstanceIndex index = this->index();
  Rng rng(6, 0);
  int held = 0;
  for (int i = 0; i < 1000; ++i) {
    const dvec3 point = test::random_point(rng, 1.0);
    const auto holder = index.holder(point);
    EXPECT_EQ(holder, brute_force_holder(point));
    held += holder ? 1 : 0;
  }
  EXPECT_GT(held, 50);
}

TEST_F(InstanceIndexTest, BoxesAreThoseOfTheTransformedVertices) {
  scatter(100, dvec3(0.0));
  const InstanceIndex index = this->index();
  for (std::size_t i = 0; i < instances_.size(); ++i) {
    const Box& box = index.boxes()[i];
    const Box truth = world_box(AuditShape(*elements_[instances_[i].element]), instances_[i]);
    EXPECT_LT(glm::distance(box.min, truth.min), 1e-14);
    EXPECT_LT(glm::distance(box.max, truth.max), 1e-14);
  }
}

TEST_F(InstanceIndexTest, OfNoInstancesNoneIsNearAndNoneHolds) {
  const InstanceIndex index = this->index();
  EXPECT_FALSE(index.nearest(dvec3(0.0), unbounded));
  EXPECT_FALSE(index.holder(dvec3(0.0)));
}

TEST_F(InstanceIndexTest, GivesTheSolidOfAnInstancesElement) {
  instances_.resize(2);
  instances_[1].element = 1;
  const InstanceIndex index = this->index();
  EXPECT_NEAR(index.solid(1).volume(), 0.15, 1e-9);
  EXPECT_NE(&index.solid(0), &index.solid(1));
}

}  // namespace
}  // namespace collage
