#include "geometry/color.h"

#include <gtest/gtest.h>

namespace collage {
namespace {

TEST(Color, DecodesSrgb) {
  EXPECT_EQ(linear_from_srgb({0, 0, 0}), glm::dvec3(0.0));
  EXPECT_EQ(linear_from_srgb({1, 1, 1}), glm::dvec3(1.0));
  EXPECT_NEAR(linear_from_srgb({128 / 255.0, 0, 0}).x, 0.21586, 1e-5);
  EXPECT_NEAR(linear_from_srgb({0, 0, 10 / 255.0}).z, 0.0030353, 1e-6);
}

TEST(Color, EncodesWhatItDecodes) {
  for (int i = 0; i <= 1000; ++i) {
    const double e = i / 1000.0;
    EXPECT_NEAR(srgb_from_linear(linear_from_srgb({e, 0, 1})).x, e, 1e-6) << e;
  }
}

}  // namespace
}  // namespace collage
