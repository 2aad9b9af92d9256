#include "preview/studio.h"

#include <gtest/gtest.h>

namespace collage {
namespace {

dvec3 light_of(const std::vector<Lamp>& lamps) {
  dvec3 sum(0.0);
  for (const Lamp& lamp : lamps) {
    EXPECT_NEAR(glm::length(lamp.direction), 1.0, 1e-12);
    sum += lamp.color;
  }
  return sum;
}

TEST(Studio, EachPartHasNearlyAllOfTheLight) {
  const LampParts parts = studio_lamps({30, 15});
  dvec3 mean(0.0);
  for (const std::vector<Lamp>& part : parts) {
    mean += light_of(part) / double{samples_a_pixel};
  }
  for (const std::vector<Lamp>& part : parts) {
    EXPECT_LT(glm::distance(light_of(part), mean), 0.06 * glm::length(mean));
  }
  const dvec3 warm(1.08, 1.026, 0.9504);
  const dvec3 cool = (0.88 + 0.4) * dvec3(0.84, 0.92, 1.0);
  EXPECT_LT(glm::distance(mean, warm + cool), 1e-9);
}

TEST(Studio, GoesRoundWithTheCamera) {
  const LampParts front = studio_lamps({0, 0});
  const LampParts side = studio_lamps({90, 0});
  EXPECT_NEAR(front[0][0].direction.z, side[0][0].direction.x, 1e-12);
  const dvec3 key = floor_light("studio")->key;
  const dvec3 turned_key = turned(key, {70, 0});
  EXPECT_NEAR(studio_room(key, {0, 0}), studio_room(turned_key, {70, 0}), 1e-9);
  EXPECT_GT(studio_room(turned_key, {70, 0}), 15.0);
  EXPECT_LT(studio_room(-turned_key, {70, 0}), 0.3);
}

TEST(Studio, BackdropDarkensTowardsTheUpperCornersAndShadowsTheFloor) {
  const dvec3 foot = studio_backdrop(0.0, -0.35);
  EXPECT_LT(glm::distance(foot, dvec3(0.96, 0.955, 0.945)), 1e-12);
  EXPECT_LT(studio_backdrop(1.0, 1.0).x, 0.6);
  EXPECT_EQ(shaded_floor(foot, 0.0), foot);
  EXPECT_LT(shaded_floor(foot, 1.0).x, 0.12);
}

}  // namespace
}  // namespace collage
