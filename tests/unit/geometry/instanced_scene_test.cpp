#include "geometry/instanced_scene.h"

#include <vector>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "support/meshes.h"

namespace collage {
namespace {

dvec3 random_vector(Rng& rng) {
  return 2.0 * dvec3(rng.uniform(), rng.uniform(), rng.uniform()) - 1.0;
}

/// Rings and boxes strewn over a cube of two units.
class InstancedSceneTest : public ::testing::Test {
 protected:
  InstancedSceneTest() {
    for (int i = 0; i < 60; ++i) {
      const dvec3 place = random_vector(rng_);
      instances_.push_back({static_cast<std::uint32_t>(i % 3), 0.05 + 0.1 * rng_.uniform(),
                            glm::normalize(glm::dquat(1.0, random_vector(rng_))), place});
      Instance& instance = instances_.back();
      if (instance.element == 1) {
        instance.translation -= instance.rotation * (instance.scale * dvec3(1000, 0, 0));
      }
    }
    for (int i = 0; i < 2003; ++i) {
      const dvec3 origin = 3.0 * random_vector(rng_);
      rays_.push_back({origin, glm::normalize(0.8 * random_vector(rng_) - origin)});
    }
  }

  /// The slow twin: the signed volumes with the edges of every triangle agree (Ericson
  /// 2005, 5.3.4).
  [[nodiscard]] RayHit by_brute_force(const Ray& ray) const {
    RayHit nearest;
    const dvec3 direction(ray.direction);
    for (std::uint32_t i = 0; i < instances_.size(); ++i) {
      const Mesh& mesh = *elements_[instances_[i].element];
      for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const dvec3 a = instances_[i].world_from_element(mesh.corner(t, 0)) - dvec3(ray.origin);
        const dvec3 b = instances_[i].world_from_element(mesh.corner(t, 1)) - dvec3(ray.origin);
        const dvec3 c = instances_[i].world_from_element(mesh.corner(t, 2)) - dvec3(ray.origin);
        const dvec3 w(glm::dot(direction, glm::cross(c, b)), glm::dot(direction, glm::cross(a, c)),
                      glm::dot(direction, glm::cross(b, a)));
        if (!(w.x > 0 && w.y > 0 && w.z > 0) && !(w.x < 0 && w.y < 0 && w.z < 0)) {
          continue;
        }
        const dvec3 weights = w / (w.x + w.y + w.z);
        const double distance = glm::dot(weights.x * a + weights.y * b + weights.z * c, direction);
        if (distance > 0.0 && distance < nearest.distance) {
          nearest = {static_cast<float>(distance), i, t, glm::vec2(weights.y, weights.z)};
        }
      }
    }
    return nearest;
  }

  Rng rng_{11, 12};
  const Mesh ring_ = test::torus_mesh(1.0, 0.4, 12, 8);
  /// Far from its own origin.
  const Mesh box_ = test::box_mesh({1000, 0, 0}, {1001, 2, 1});
  const std::vector<const Mesh*> elements_{&ring_, &box_, &ring_};
  std::vector<Instance> instances_;
  std::vector<Ray> rays_;
};

TEST_F(InstancedSceneTest, FindsWhatEveryTriangleLookedAtFinds) {
  const InstancedScene scene(elements_, instances_);
  int met = 0;
  int different = 0;
  for (std::size_t i = 0; i < rays_.size(); ++i) {
    const RayHit wanted = by_brute_force(rays_[i]);
    const RayHit hit = scene.closest(rays_[i]);
    EXPECT_EQ(hit.met(), scene.occluded(rays_[i])) << i;
    if (hit.met() != wanted.met() || hit.instance != wanted.instance ||
        hit.triangle != wanted.triangle) {
      ++different;  // past an edge as near as float can tell
      continue;
    }
    if (wanted.met()) {
      ++met;
      EXPECT_NEAR(hit.distance, wanted.distance, 1e-4) << i;
      EXPECT_NEAR(hit.weights.x, wanted.weights.x, 2e-3) << i;
      EXPECT_NEAR(hit.weights.y, wanted.weights.y, 2e-3) << i;
    }
  }
  EXPECT_GT(met, 500);
  EXPECT_LT(met, 1900);
  EXPECT_LE(different, 2);
}

TEST_F(InstancedSceneTest, IsTheSameBuiltOnAnyNumberOfThreads) {
  const auto built_on = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return InstancedScene(elements_, instances_);
  };
  const InstancedScene one = built_on(1);
  const InstancedScene many = built_on(4);
  for (const Ray& ray : rays_) {
    const RayHit hit = one.closest(ray);
    const RayHit same = many.closest(ray);
    EXPECT_EQ(hit.distance, same.distance);
    EXPECT_EQ(hit.instance, same.instance);
    EXPECT_EQ(hit.triangle, same.triangle);
  }
}

TEST(InstancedScene, OfNothingStopsNothing) {
  const InstancedScene scene({}, {});
  EXPECT_FALSE(scene.closest({}).met());
  EXPECT_FALSE(scene.occluded({}));
}

TEST(InstancedScene, LeavesTheThreadsOfOthersAlone) {
  const tbb::global_control two(tbb::global_control::max_allowed_parallelism, 2);
  const Mesh box = test::box_mesh({0, 0, 0}, {1, 1, 1});
  const Mesh* const element = &box;
  const Instance instance;
  const InstancedScene scene(std::span(&element, 1), std::span(&instance, 1));
  EXPECT_EQ(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism), 2);
}

}  // namespace
}  // namespace collage
