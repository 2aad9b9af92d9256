#include "audit/kinds.h"

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace collage {
namespace {

std::vector<dvec3> random_places(std::size_t count) {
  Rng rng(71, 0);
  std::vector<dvec3> places;
  for (std::size_t i = 0; i < count; ++i) {
    places.push_back(test::random_point(rng, 1.0));
  }
  return places;
}

/// Fisher and Yates.
void shuffle(std::vector<std::uint32_t>& kinds, Rng& rng) {
  for (std::size_t i = kinds.size(); i > 1; --i) {
    std::swap(kinds[i - 1], kinds[rng.below(i)]);
  }
}

TEST(Kinds, CountsAndShares) {
  const std::vector<std::uint32_t> kinds{0, 2, 2, 0, 2};
  const Kinds result = mix_of_kinds(kinds, random_places(5), 4);
  EXPECT_EQ(result.counts, (std::vector<std::uint64_t>{2, 0, 3, 0}));
  EXPECT_EQ(result.shares, (std::vector<double>{0.4, 0.0, 0.6, 0.0}));
}

TEST(Kinds, ClusteringOfKindsAtRandomHasTheMeanAndDeviationStated) {
  const auto places = random_places(60);
  std::vector<std::uint32_t> kinds;
  for (std::uint32_t i = 0; i < 60; ++i) {
    kinds.push_back(i < 35 ? 0 : i < 50 ? 1 : 2);
  }
  Rng rng(72, 0);
  constexpr int trials = 4000;
  double ratio = 0.0;
  double z = 0.0;
  double squares = 0.0;
  for (int trial = 0; trial < trials; ++trial) {
    shuffle(kinds, rng);
    const auto clustering = mix_of_kinds(kinds, places, 3).clustering;
    ratio += clustering->ratio / trials;
    z += clustering->z_score / trials;
    squares += clustering->z_score * clustering->z_score / trials;
  }
  EXPECT_NEAR(ratio, 1.0, 0.01);
  EXPECT_NEAR(z, 0.0, 0.05);
  EXPECT_NEAR(squares, 1.0, 0.07);
}

TEST(Kinds, ClusteringSeesHalvesAndCheckers) {
  std::vector<dvec3> places;
  std::vector<std::uint32_t> halves;
  std::vector<std::uint32_t> checkers;
  for (int i = 0; i < 1000; ++i) {
    places.emplace_back(i % 10, i / 10 % 10, i / 100);
    halves.push_back(i < 500 ? 0 : 1);
    checkers.push_back(static_cast<std::uint32_t>(i % 10 + i / 10 % 10 + i / 100) % 2);
  }
  const auto split = mix_of_kinds(halves, places, 2).clustering;
  EXPECT_GT(split->ratio, 1.8);
  EXPECT_GT(split->z_score, 10.0);
  EXPECT_NEAR(split->by_chance, 499.0 / 999.0, 1e-12);
  const auto mixed = mix_of_kinds(checkers, places, 2).clustering;
  EXPECT_EQ(mixed->same, 0.0);
  EXPECT_LT(mixed->z_score, -10.0);
}

TEST(Kinds, ScoreIsZeroWhereEveryLabellingComesToTheSame) {
  const std::vector<dvec3> two_pairs{dvec3(0), dvec3(1), dvec3(10), dvec3(11)};
  const auto clustering =
      mix_of_kinds(std::vector<std::uint32_t>{0, 0, 0, 1}, two_pairs, 2).clustering;
  EXPECT_EQ(clustering->same, 0.5);
  EXPECT_EQ(clustering->by_chance, 0.5);
  EXPECT_EQ(clustering->z_score, 0.0);
}

TEST(Kinds, ClusteringIsNothingWhereChanceLeavesNoChoice) {
  EXPECT_FALSE(mix_of_kinds({}, {}, 1).clustering);
  const auto places = random_places(5);
  EXPECT_FALSE(mix_of_kinds(std::vector<std::uint32_t>(5, 0), places, 1).clustering);
  EXPECT_FALSE(mix_of_kinds(std::vector<std::uint32_t>{0, 1, 2, 3, 4}, places, 5).clustering);
  const std::vector<std::uint32_t> three{0, 0, 1};
  EXPECT_FALSE(mix_of_kinds(three, std::span(places).first(3), 2).clustering);
}

}  // namespace
}  // namespace collage
