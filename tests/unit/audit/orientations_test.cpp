#include "audit/orientations.h"

#include <cmath>
#include <vector>

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include "base/rng.h"

namespace collage {
namespace {

/// Uniform (Shoemake 1992, "Uniform random rotations").
glm::dquat random_rotation(Rng& rng) {
  const double u = rng.uniform();
  const double a = glm::two_pi<double>() * rng.uniform();
  const double b = glm::two_pi<double>() * rng.uniform();
  return {std::sqrt(u) * std::cos(b), std::sqrt(1.0 - u) * std::sin(a),
          std::sqrt(1.0 - u) * std::cos(a), std::sqrt(u) * std::sin(b)};
}

std::vector<Instance> random_instances(std::size_t count, std::uint64_t seed) {
  Rng rng(seed, 0);
  std::vector<Instance> instances(count);
  for (Instance& instance : instances) {
    instance.rotation = random_rotation(rng);
  }
  return instances;
}

/// The other formula: by the mean rotation matrix.
double evenness_by_mean_matrix(const std::vector<Instance>& instances) {
  glm::dmat3 mean(0.0);
  for (const Instance& instance : instances) {
    mean += glm::mat3_cast(instance.rotation) / static_cast<double>(instances.size());
  }
  double squares = 0.0;
  for (int column = 0; column < 3; ++column) {
    squares += glm::dot(mean[column], mean[column]);
  }
  return 1.0 - squares / 3.0;
}

TEST(Orientations, EvennessOfUniformRotationsIsAsExpectedAndBinghamsStatisticNine) {
  constexpr int trials = 400;
  double evenness = 0.0;
  double bingham = 0.0;
  double squares = 0.0;
  for (int trial = 0; trial < trials; ++trial) {
    const auto result = orientations(random_instances(50, static_cast<std::uint64_t>(trial)));
    evenness += result->evenness / trials;
    bingham += result->bingham / trials;
    squares += result->bingham * result->bingham / trials;
    EXPECT_EQ(result->expected_evenness, 0.98);
  }
  EXPECT_NEAR(evenness, 0.98, 0.0015);
  EXPECT_NEAR(bingham, 9.0, 0.7);
  EXPECT_NEAR(squares - bingham * bingham, 18.0, 4.0);  // the variance of χ² of 9 degrees
}

TEST(Orientations, BothFormulasAgreeAndTheSignOfAQuaternionDoesNotCount) {
  for (std::size_t count : {1U, 2U, 7U, 100U}) {
    auto instances = random_instances(count, 5);
    const double evenness = orientations(instances)->evenness;
    EXPECT_NEAR(evenness, evenness_by_mean_matrix(instances), 1e-14);
    instances[0].rotation = -instances[0].rotation;
    EXPECT_NEAR(orientations(instances)->evenness, evenness, 1e-15);
    const auto n = static_cast<double>(count);
    EXPECT_NEAR(orientations(instances)->bingham, 9.0 * n * (1.0 - evenness), 1e-11);
  }
}

TEST(Orientations, OfKnownSets) {
  std::vector<Instance> instances(36);
  EXPECT_NEAR(orientations(instances)->evenness, 0.0, 1e-15);  // all alike
  for (std::size_t i = 0; i < instances.size(); ++i) {
    const double turn = glm::two_pi<double>() * static_cast<double>(i) / 36.0;
    instances[i].rotation = glm::angleAxis(turn, glm::dvec3(0, 1, 0));
  }
  EXPECT_NEAR(orientations(instances)->evenness, 2.0 / 3.0, 1e-14);  // all upright
  instances.resize(4);
  instances[0].rotation = {1, 0, 0, 0};
  instances[1].rotation = {0, 1, 0, 0};
  instances[2].rotation = {0, 0, 1, 0};
  instances[3].rotation = {0, 0, 0, 1};
  EXPECT_NEAR(orientations(instances)->evenness, 1.0, 1e-15);  // balanced
  EXPECT_FALSE(orientations({}));
}

}  // namespace
}  // namespace collage
