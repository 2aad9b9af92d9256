#include "audit/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace collage {
namespace {

SurfaceDistance distance_between(const Mesh& target, const Mesh& element, const Instance& instance,
                                 const SurfaceDistanceOptions& options = {}) {
  const std::vector<const Mesh*> elements{&element};
  Status status;
  return *surface_distance(TargetShape(target), InstanceIndex(elements, {&instance, 1}), options,
                           status);
}

TEST(SurfaceDistance, OfABallInABallIsTheDifferenceOfTheirRadii) {
  const Mesh ball = test::blob_mesh(10.0, 0.0, 60);
  Instance instance;
  instance.scale = 0.9;
  const SurfaceDistance result = distance_between(ball, ball, instance);
  EXPECT_EQ(result.points, 20000U);
  EXPECT_NEAR(result.mean, 0.05, 1e-4);
  EXPECT_NEAR(result.p95, 0.05, 1e-4);
  EXPECT_EQ(result.share_within, 0.0);
  EXPECT_EQ(distance_between(ball, ball, instance, {2000, 0.051}).share_within, 1.0);
}

TEST(SurfaceDistance, OfABoxInABoxFollowsTheFormula) {
  // From (1, u, v) on a face of the box to the one half as large.
  std::vector<double> truth;
  for (int i = 0; i < 500; ++i) {
    for (int j = 0; j < 500; ++j) {
      const double u = std::max(0.0, (i + 0.5) / 500.0 - 0.5);
      const double v = std::max(0.0, (j + 0.5) / 500.0 - 0.5);
      truth.push_back(std::sqrt(0.25 + u * u + v * v) / 2.0);
    }
  }
  std::sort(truth.begin(), truth.end());
  const double mean = std::accumulate(truth.begin(), truth.end(), 0.0) / 250000.0;

  const Mesh box = test::box_mesh(dvec3(-1), dvec3(1));
  Instance instance;
  instance.scale = 0.5;
  const SurfaceDistance result = distance_between(box, box, instance, {20000, 0.25, 10});
  EXPECT_NEAR(result.mean, mean, 0.0003);
  EXPECT_NEAR(result.p95, truth[237500], 0.001);
  EXPECT_NEAR(result.share_within, 0.25, 0.001);
  EXPECT_EQ(std::accumulate(result.histogram.begin(), result.histogram.end(), std::uint64_t{0}),
            result.points);
  EXPECT_NEAR(10.0 * result.bin_width, std::sqrt(0.75) / 2.0, 0.005);
  EXPECT_EQ(result.histogram[4], 0U);  // nothing is nearer than 0.25
  EXPECT_GT(result.histogram[5], 5000U);
}

TEST(SurfaceDistance, IsThatToTheNearestOfManyInstances) {
  const Mesh box = test::box_mesh(dvec3(-1), dvec3(1));
  const Mesh plate = test::box_mesh(dvec3(-1, -1, -1), dvec3(1, 1, -0.99));
  const std::vector<const Mesh*> elements{&box, &plate};
  std::vector<Instance> instances(2);
  instances[0].scale = 0.5;
  instances[1].element = 1;
  Status status;
  const auto with_plate =
      surface_distance(TargetShape(box), InstanceIndex(elements, instances), {}, status);
  EXPECT_LT(with_plate->mean, distance_between(box, box, instances[0]).mean);
  EXPECT_GT(with_plate->share_within, 1.0 / 6.0 - 0.001);  // the plate's face
}

TEST(SurfaceDistance, CountsOnlyWhereTheSolidEnds) {
  // Two bars that cross: a third of each is within the other, and would be farthest from itself.
  Mesh cross = test::box_mesh(dvec3(-3, -1, -1), dvec3(3, 1, 1));
  const Mesh bar = test::box_mesh(dvec3(-1, -3, -0.9), dvec3(1, 3, 0.9));
  for (const uvec3& t : bar.triangles) {
    cross.triangles.push_back(t + 8U);
  }
  cross.positions.insert(cross.positions.end(), bar.positions.begin(), bar.positions.end());
  const double outside =
      (56.0 - 2 * 2 * 1.8) + (2 * 6 * 2 + 2 * 6 * 1.8 + 2 * 2 * 1.8) - 2 * (2 * 2) - 2 * (2 * 1.8);
  const SurfaceDistance result = distance_between(cross, cross, Instance{});
  EXPECT_NEAR(static_cast<double>(result.points), 20000.0 * outside / surface_area(cross), 100.0);
  EXPECT_LT(result.p95, 1e-9);
}

TEST(SurfaceDistance, IsNothingWithoutInstancesOrWithoutASolid) {
  const Mesh box = test::box_mesh(dvec3(-1), dvec3(1));
  Status status;
  EXPECT_FALSE(surface_distance(TargetShape(box), InstanceIndex({}, {}), {}, status));
  Mesh sheet = box;
  sheet.triangles.resize(2);
  const std::vector<const Mesh*> elements{&box};
  const Instance instance;
  EXPECT_FALSE(
      surface_distance(TargetShape(sheet), InstanceIndex(elements, {&instance, 1}), {}, status));
}

}  // namespace
}  // namespace collage
