#include "audit/fill.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace collage {
namespace {

Fill fill_of(const Mesh& target, const Mesh& element, const std::vector<Instance>& instances,
             std::size_t points = 100000) {
  const std::vector<const Mesh*> elements{&element};
  Status status;
  return *fill(TargetShape(target), InstanceIndex(elements, instances), {points}, status);
}

TEST(Fill, OfACubeWithACubeInItsCore) {
  // The core begins half way down: outer shells are empty, inner ones full.
  const Mesh cube = test::box_mesh(dvec3(4, 0, 0), dvec3(6, 2, 2));
  const Mesh core = test::box_mesh(dvec3(-1), dvec3(1));
  Instance instance;
  instance.scale = 0.5;
  instance.translation = dvec3(5, 1, 1);
  const Fill result = fill_of(cube, core, {instance});
  EXPECT_NEAR(result.by_volume, 0.125, 1e-12);
  EXPECT_NEAR(*result.by_points.share(), 0.125, 3.0 * *result.by_points.deviation());
  const auto points = static_cast<double>(result.by_points.points);
  EXPECT_NEAR(points, 100000.0, 5000.0);
  EXPECT_NEAR(result.greatest_depth, 0.5, 0.02);
  // Half sides of the cubes between shells, as shares of the target's.
  const double step = 0.2 * result.greatest_depth;
  const auto cubed = [](double x) { return x * x * x; };
  for (std::size_t s = 0; s < 10; ++s) {
    const double outer = 1.0 - step * static_cast<double>(s);
    const double inner = s < 9 ? outer - step : 0.0;
    const double volume = cubed(outer) - cubed(inner);
    const double filled = cubed(std::min(outer, 0.5)) - cubed(std::min(inner, 0.5));
    EXPECT_NEAR(static_cast<double>(result.by_shell[s].points) / points, volume, 0.003);
    EXPECT_NEAR(*result.by_shell[s].share(), filled / volume, 0.02) << s;
  }
}

TEST(Fill, AddsUpAllInstancesAndCountsPointsOnce) {
  const Mesh cube = test::box_mesh(dvec3(0), dvec3(2));
  const Mesh eighth = test::box_mesh(dvec3(0), dvec3(1));
  std::vector<Instance> instances(3);
  instances[1].translation = dvec3(1, 0, 1);
  instances[2].translation = dvec3(1, 1, 1);
  const Fill result = fill_of(cube, eighth, instances);
  EXPECT_NEAR(result.by_volume, 0.375, 1e-12);
  EXPECT_NEAR(*result.by_points.share(), 0.375, 2.0 * *result.by_points.deviation());
  std::uint64_t in_shells = 0;
  for (const Fill::Sample& shell : result.by_shell) {
    in_shells += shell.points;
    EXPECT_NEAR(*shell.share(), 0.375, 0.05 + 3.0 * *shell.deviation());
  }
  EXPECT_EQ(in_shells, result.by_points.points);
}

TEST(Fill, StratifiedPointsDeviateLessThanStated) {
  // Balls in many places: the deviation from the truth, over that stated, would be 1 at random.
  const Mesh cube = test::box_mesh(dvec3(-1), dvec3(1));
  const Mesh ball = test::blob_mesh(1.0, 0.0, 20);
  Rng rng(61, 0);
  double squares = 0.0;
  for (int i = 0; i < 20; ++i) {
    Instance instance;
    instance.scale = 0.5;
    instance.translation = test::random_point(rng, 0.4);
    const Fill result = fill_of(cube, ball, {instance}, 2000);
    squares +=
        std::pow((*result.by_points.share() - result.by_volume) / *result.by_points.deviation(),
                 2) /
        20.0;
  }
  EXPECT_LT(squares, 0.6);
}

TEST(Fill, OfATargetThatIsThinForItsBox) {
  // A shell: a ball without another in it. 4π/3 (1 - 0.99³) of 8 is 1.5 %.
  Mesh target = test::blob_mesh(1.0, 0.0, 60);
  Mesh hollow = test::blob_mesh(0.99, 0.0, 60);
  reverse_orientation(hollow);
  const auto offset = static_cast<std::uint32_t>(target.positions.size());
  target.positions.insert(target.positions.end(), hollow.positions.begin(), hollow.positions.end());
  for (const uvec3& t : hollow.triangles) {
    target.triangles.push_back(t + offset);
  }
  const Fill result =
      fill_of(target, test::box_mesh(dvec3(-2, -2, -2), dvec3(2, 0, 2)), {Instance{}}, 20000);
  EXPECT_NEAR(static_cast<double>(result.by_points.points), 20000.0, 1000.0);
  EXPECT_NEAR(*result.by_points.share(), 0.5, 0.02);
  EXPECT_NEAR(result.greatest_depth, 0.0025, 0.0003);
}

TEST(Fill, TakesNoMorePointsThanAskedForOfPlatesAndNeedles) {
  for (const dvec3& size : {dvec3(1, 1e-7, 1), dvec3(1e-6, 1e-6, 1), dvec3(1, 0.01, 0.5)}) {
    const Mesh target = test::box_mesh(dvec3(0), size);
    const Mesh half = test::box_mesh(dvec3(0), size * dvec3(1, 1, 0.5));
    const Fill result = fill_of(target, half, {Instance{}}, 5000);
    EXPECT_NEAR(static_cast<double>(result.by_points.points), 5000.0, 250.0);
    EXPECT_NEAR(*result.by_points.share(), 0.5, 0.02);
  }
}

TEST(Fill, OfAnEmptySculptureIsNoneAndOfATargetWithoutVolumeNothing) {
  const Mesh cube = test::box_mesh(dvec3(0), dvec3(2));
  EXPECT_EQ(fill_of(cube, cube, {}).by_volume, 0.0);
  EXPECT_EQ(*fill_of(cube, cube, {}).by_points.share(), 0.0);
  Mesh sheet = cube;
  sheet.triangles.resize(2);
  Status status;
  EXPECT_FALSE(fill(TargetShape(sheet), InstanceIndex({}, {}), {}, status));
}

}  // namespace
}  // namespace collage
