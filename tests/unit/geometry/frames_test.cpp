#include "geometry/frames.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace collage {
namespace {

void expect_right_handed(const Frame& frame) {
  EXPECT_NEAR(glm::length(frame.u), 1.0, 1e-9);
  EXPECT_NEAR(glm::dot(frame.u, frame.along), 0.0, 1e-9);
  EXPECT_NEAR(glm::distance(glm::cross(frame.u, frame.v), frame.along), 0.0, 1e-9);
}

TEST(Frames, DoNotTurnOnAPlaneCurve) {
  const auto curve = bezier_curve({0, 0, 0}, {1, 2, 0}, {3, -2, 0}, {4, 0, 0}, 9);
  for (const Frame& frame : frames_along(curve, {0, 0, 1})) {
    expect_right_handed(frame);
    EXPECT_NEAR(frame.u.z, 1.0, 1e-9);
  }
}

TEST(Frames, TurnOnAHelixAsItsTorsionSays) {
  // A helix of radius r and pitch 2πc turns its Frenet frame by c / sqrt(r² + c²) a unit of angle
  // against the rotation-minimising one.
  constexpr double c = 0.5;
  constexpr double end = 3.0;
  constexpr int steps = 200;
  std::vector<CurvePoint> helix;
  for (int i = 0; i <= steps; ++i) {
    const double t = end * i / steps;
    helix.push_back(
        {{std::cos(t), std::sin(t), c * t}, glm::normalize(dvec3(-std::sin(t), std::cos(t), c))});
  }
  const std::vector<Frame> frames = frames_along(helix, {-1, 0, 0});
  const dvec3 frenet(-std::cos(end), -std::sin(end), 0.0);
  const Frame& last = frames.back();
  expect_right_handed(last);
  const double turn = std::atan2(glm::dot(frenet, last.v), glm::dot(frenet, last.u));
  EXPECT_NEAR(turn, end * c / std::sqrt(1.0 + c * c), 1e-4);
}

TEST(Frames, BezierCurveRunsFromItsFirstPointToItsLast) {
  const auto curve = bezier_curve({0, 0, 0}, {0, 3, 0}, {3, 3, 0}, {3, 0, 0}, 2);
  ASSERT_EQ(curve.size(), 3U);
  EXPECT_EQ(curve[0].along, dvec3(0, 1, 0));
  EXPECT_EQ(curve[1].position, dvec3(1.5, 2.25, 0));
  EXPECT_EQ(curve[2].position, dvec3(3, 0, 0));
  EXPECT_EQ(curve[2].along, dvec3(0, -1, 0));
}

}  // namespace
}  // namespace collage
