#include "geometry/ray_scene.h"

#include <vector>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace collage {
namespace {

Box world_box(const Mesh& mesh, const Instance& instance) {
  Box box;
  for (const dvec3& position : mesh.positions) {
    box.include(instance.world_from_element(position));
  }
  return box;
}

/// A mesh, instances of it, and the scene of them.
class Rays {
 public:
  Rays(const Mesh& mesh, const std::vector<Instance>& instances)
      : mesh_(mesh), instances_(instances), scene_(make()) {}

  [[nodiscard]] bool occluded(const dvec3& origin, const dvec3& direction) const {
    return scene_.occluded(origin, direction);
  }

  /// The slow twin: the signed volumes with the edges of every triangle agree (Ericson
  /// 2005, 5.3.4).
  [[nodiscard]] bool occluded_by_brute_force(const dvec3& origin, const dvec3& direction) const {
    for (const Instance& instance : instances_) {
      for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
        const dvec3 a = instance.world_from_element(mesh_.corner(t, 0)) - origin;
        const dvec3 b = instance.world_from_element(mesh_.corner(t, 1)) - origin;
        const dvec3 c = instance.world_from_element(mesh_.corner(t, 2)) - origin;
        const double u = glm::dot(direction, glm::cross(c, b));
        const double v = glm::dot(direction, glm::cross(a, c));
        const double w = glm::dot(direction, glm::cross(b, a));
        const bool through = (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
        const dvec3 hit = (u * a + v * b + w * c) / (u + v + w);
        if (through && glm::dot(hit, direction) > 0.0) {
          return true;
        }
      }
    }
    return false;
  }

 private:
  [[nodiscard]] RayScene make() const {
    const std::vector<const Mesh*> elements{&mesh_};
    std::vector<Box> boxes;
    for (const Instance& instance : instances_) {
      boxes.push_back(world_box(mesh_, instance));
    }
    return {elements, instances_, boxes};
  }

  Mesh mesh_;
  std::vector<Instance> instances_;
  RayScene scene_;
};

std::vector<Instance> scattered(std::size_t count, const dvec3& at) {
  Rng rng(11, 0);
  std::vector<Instance> instances(count);
  for (Instance& instance : instances) {
    const dvec3 axis = test::random_point(rng, 1.0);
    instance.scale = 0.05 + 0.2 * rng.uniform();
    instance.rotation = glm::normalize(glm::dquat(0.5, axis.x, axis.y, axis.z));
    instance.translation = at + test::random_point(rng, 1.0);
  }
  return instances;
}

TEST(RayScene, AgreesWithBruteForceWhereverTheInstancesAre) {
  for (const double offset : {0.0, 1e6}) {
    const dvec3 center(offset, -offset, 0.0);
    const Rays rays(test::torus_mesh(1.0, 0.4, 12, 6), scattered(60, center));
    Rng rng(12, 0);
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
      const dvec3 origin = center + test::random_point(rng, 1.5);
      const dvec3 direction = glm::normalize(test::random_point(rng, 1.0));
      const bool truth = rays.occluded_by_brute_force(origin, direction);
      EXPECT_EQ(rays.occluded(origin, direction), truth) << i;
      hits += truth ? 1 : 0;
    }
    EXPECT_GT(hits, 300);
    EXPECT_LT(hits, 1700);
  }
}

TEST(RayScene, ARayStartsAtItsOriginAndHasNoEnd) {
  const Rays rays(test::box_mesh(dvec3(-1), dvec3(1)), {Instance{}});
  EXPECT_TRUE(rays.occluded({0.1, 0.2, -1e9}, {0, 0, 1}));
  EXPECT_FALSE(rays.occluded({0.1, 0.2, -1e9}, {0, 0, -1}));
  EXPECT_TRUE(rays.occluded({0.1, 0.2, 0.3}, {0, 0, 1}));  // from within
  EXPECT_FALSE(rays.occluded({0.1, 0.2, 1.001}, {0, 0, 1}));
}

TEST(RayScene, HasNoCracksBetweenTriangles) {
  const Mesh ball = test::blob_mesh(1.0, 0.0, 40);
  const Rays rays(ball, {Instance{}});
  for (const uvec3& t : ball.triangles) {
    const dvec3 on_edge = 0.5 * (ball.positions[t.x] + ball.positions[t.y]);
    EXPECT_TRUE(rays.occluded(3.0 * on_edge, -glm::normalize(on_edge)));
    EXPECT_TRUE(rays.occluded(3.0 * ball.positions[t.z], -glm::normalize(ball.positions[t.z])));
  }
}

TEST(RayScene, OfNothingOccludesNothing) {
  EXPECT_FALSE(RayScene({}, {}, {}).occluded({0, 0, 5}, {0, 0, -1}));
}

TEST(RayScene, LooksFartherThanFloatReaches) {
  Instance near;
  Instance far;
  far.translation = dvec3(1e30, 0.0, 0.0);
  const Rays rays(test::box_mesh(dvec3(-1), dvec3(1)), {near, far});
  EXPECT_FALSE(rays.occluded(dvec3(5e29, 1e29, 0.0), dvec3(0, 0, 1)));
  EXPECT_TRUE(rays.occluded(dvec3(0, 1e300, 0), dvec3(0, -1, 0)));
  EXPECT_FALSE(rays.occluded(dvec3(0, 1e300, 0), dvec3(0, 0, -1)));
}

}  // namespace
}  // namespace collage
