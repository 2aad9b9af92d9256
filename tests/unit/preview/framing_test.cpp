#include "preview/framing.h"

#include <cmath>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace collage {
namespace {

/// Two boxes of different sizes, off the axis.
class FramingTest : public ::testing::Test {
 protected:
  FramingTest() {
    composition_.elements.push_back({"box", box_});
    composition_.instances = instances_;
    bounds_ = bounds_of(composition_);
    stand_ = stand_of(composition_, bounds_);
  }

  /// How far the sculpture reaches towards the picture's edges, 1 being at them.
  [[nodiscard]] double reach(const Camera& camera) const {
    double farthest = 0.0;
    for (const Instance& instance : instances_) {
      for (const dvec3& position : box_.positions) {
        const dvec3 seen =
            stand_.studio_from_world(instance.world_from_element(position)) - camera.eye;
        const double depth = glm::dot(seen, camera.forward);
        farthest =
            std::max({farthest, std::abs(glm::dot(seen, camera.right)) / depth / camera.tan_x,
                      std::abs(glm::dot(seen, camera.up)) / depth / camera.tan_y});
      }
    }
    return farthest;
  }

  const Mesh box_ = test::box_mesh({-1, -1, -1}, {1, 1, 1});
  const std::vector<Instance> instances_{{0, 1.0, {1, 0, 0, 0}, {10, 5, 3}},
                                         {0, 0.3, {1, 0, 0, 0}, {12, 7, 4}}};
  Composition composition_;
  CompositionBounds bounds_;
  Stand stand_;
};

TEST_F(FramingTest, StandsOnTheFloorTwoUnitsLarge) {
  EXPECT_DOUBLE_EQ(stand_.studio_from_world(bounds_.shown.min).y, 0.0);
  EXPECT_DOUBLE_EQ(std::max(stand_.height, 2.0 * stand_.radius), 2.0);
  const Instance placed = stand_.studio_from_world(instances_[1]);
  const dvec3 corner(1, -1, 1);
  EXPECT_LT(glm::distance(placed.world_from_element(corner),
                          stand_.studio_from_world(instances_[1].world_from_element(corner))),
            1e-12);
}

TEST_F(FramingTest, FillsThePictureWithWhatTheViewShows) {
  for (const Bearing bearing : {Bearing{0, 10}, Bearing{123, 35}, Bearing{-40, 90}}) {
    for (const double aspect : {4.0 / 3.0, 0.5}) {
      const Camera camera = frame(stand_, bounds_, bearing, aspect, Framing::view);
      EXPECT_LE(reach(camera), 0.87 * (1.0 + 1e-9));
      EXPECT_GT(reach(camera), 0.85);
    }
  }
}

TEST_F(FramingTest, LeavesRoomToTurnInOneSize) {
  const Camera first = frame(stand_, bounds_, {0, 15}, 1.5, Framing::all_round);
  for (const double azimuth : {0.0, 77.0, 200.0}) {
    const Camera camera = frame(stand_, bounds_, {azimuth, 15}, 1.5, Framing::all_round);
    EXPECT_LE(reach(camera), 0.87 * (1.0 + 1e-9));
    EXPECT_NEAR(glm::length(camera.eye), glm::length(first.eye), 1e-9);
  }
}

TEST_F(FramingTest, LooksAtTheSideThatTheAzimuthNames) {
  const Camera front = frame(stand_, bounds_, {0, 20}, 1.0, Framing::view);
  EXPECT_GT(front.eye.z, 1.0);
  EXPECT_NEAR(front.right.x, 1.0, 1e-12);
  const Camera right = frame(stand_, bounds_, {90, 20}, 1.0, Framing::view);
  EXPECT_GT(right.eye.x, 1.0);
  EXPECT_LT(glm::distance(front.direction(0, 0), front.forward), 1e-12);
}

TEST_F(FramingTest, NeverLooksFromBelowTheFloor) {
  EXPECT_GE(frame(stand_, bounds_, {0, -90}, 1.0, Framing::view).eye.y, 0.06);
}

}  // namespace
}  // namespace collage
