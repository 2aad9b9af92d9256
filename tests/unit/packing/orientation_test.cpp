#include "packing/orientation.h"

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace collage {
namespace {

TEST(RotationBetween, TakesOneDirectionToTheOther) {
  Rng rng(1, 0);
  for (int i = 0; i < 1000; ++i) {
    const dvec3 from = glm::normalize(test::random_point(rng, 1.0));
    const dvec3 to = glm::normalize(test::random_point(rng, 1.0));
    const glm::dquat rotation = rotation_between(from, to);
    EXPECT_LT(glm::distance(rotation * from, to), 1e-12);
    EXPECT_NEAR(glm::length(rotation), 1.0, 1e-12);
  }
}

TEST(RotationBetween, HoldsForTheSameAndForOppositeDirections) {
  for (const dvec3& axis : {dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, -1)}) {
    EXPECT_LT(glm::distance(rotation_between(axis, axis) * axis, axis), 1e-12);
    EXPECT_LT(glm::distance(rotation_between(axis, -axis) * axis, -axis), 1e-12);
    const dvec3 nearly = glm::normalize(-axis + dvec3(1e-9, 2e-9, 3e-9));
    EXPECT_LT(glm::distance(rotation_between(axis, nearly) * axis, nearly), 1e-7);
  }
}

TEST(Orientation, KeepsTheDirectionWhateverTheSpin) {
  const dvec3 from = glm::normalize(dvec3(1, 2, 3));
  const dvec3 to = glm::normalize(dvec3(-1, 0.2, 0.7));
  for (const double spin : {0.0, 1.0, 3.0, 6.0}) {
    EXPECT_LT(glm::distance(orientation(from, to, spin) * from, to), 1e-12);
  }
  EXPECT_GT(glm::distance(orientation(from, to, 0.0) * dvec3(1, 0, 0),
                          orientation(from, to, 1.0) * dvec3(1, 0, 0)),
            0.1);
}

}  // namespace
}  // namespace collage
