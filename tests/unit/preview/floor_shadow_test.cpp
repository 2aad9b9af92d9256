#include "preview/floor_shadow.h"

#include <gtest/gtest.h>

#include "preview/studio.h"
#include "support/meshes.h"

namespace collage {
namespace {

/// A box that stands in the middle, 0.5 wide and 1 high.
class FloorShadowTest : public ::testing::Test {
 protected:
  FloorShadowTest() {
    stand_.radius = 1.0;
    stand_.height = 1.0;
  }
  [[nodiscard]] FloorShadow shadow(const std::vector<Instance>& instances,
                                   const Bearing& bearing) const {
    const Mesh* const element = &box_;
    return {InstancedScene(std::span(&element, 1), instances), stand_, bearing,
            *floor_light("studio")};
  }
  const Mesh box_ = test::box_mesh({-0.25, 0.01, -0.25}, {0.25, 1, 0.25});
  const std::vector<Instance> one_{Instance{}};
  Stand stand_;
};

TEST_F(FloorShadowTest, IsDeepBelowAndGoneFarAway) {
  const FloorShadow shadow = this->shadow(one_, {0, 0});
  EXPECT_GT(shadow.stopped(0, 0), 0.9);
  EXPECT_LE(shadow.stopped(0, 0), 1.0);
  EXPECT_EQ(shadow.stopped(3, 0), 0.0);
  EXPECT_EQ(shadow.stopped(0, -1e6), 0.0);
}

TEST_F(FloorShadowTest, LiesOppositeTheKeyLight) {
  for (const double azimuth : {0.0, 135.0}) {
    const Bearing bearing{azimuth, 0};
    const FloorShadow shadow = this->shadow(one_, bearing);
    const dvec3 key = glm::normalize(turned(floor_light("studio")->key, bearing) * dvec3(1, 0, 1));
    EXPECT_GT(shadow.stopped(-0.7 * key.x, -0.7 * key.z),
              shadow.stopped(0.7 * key.x, 0.7 * key.z) + 0.2);
  }
}

TEST_F(FloorShadowTest, IsSmooth) {
  const FloorShadow shadow = this->shadow(one_, {0, 0});
  double before = shadow.stopped(-2.4, 0.1);
  for (double x = -2.399; x < 2.4; x += 0.001) {
    const double here = shadow.stopped(x, 0.1);
    EXPECT_LT(std::abs(here - before), 0.02) << x;
    before = here;
  }
}

TEST_F(FloorShadowTest, OfNothingIsNone) { EXPECT_EQ(shadow({}, {0, 0}).stopped(0.1, 0.2), 0.0); }

}  // namespace
}  // namespace collage
