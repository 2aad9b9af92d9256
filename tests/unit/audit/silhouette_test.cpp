#include "audit/silhouette.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace collage {
namespace {

using Pixel = SilhouettePicture::Pixel;

Silhouette look(const Mesh& target, const Mesh& element, const Instance& instance,
                const SilhouetteOptions& options = {}) {
  const std::vector<const Mesh*> elements{&element};
  Status status;
  return silhouette(target, InstanceIndex(elements, {&instance, 1}), options, status);
}

TEST(Silhouette, OfABallInABallIsTheRatioOfTheirDiscs) {
  const Mesh ball = test::blob_mesh(10.0, 0.0, 60);
  Instance instance;
  instance.scale = 0.8;
  instance.translation = {1, -1, 0.5};  // within, off centre
  const Silhouette result = look(ball, ball, instance);
  ASSERT_EQ(result.views.size(), 42U);
  for (const auto& view : result.views) {
    EXPECT_NEAR(view.iou, 0.64, 0.002);
    EXPECT_GE(view.iou, result.worst);
  }
  EXPECT_NEAR(result.mean, 0.64, 0.0005);
}

TEST(Silhouette, CountsWhatSticksOut) {
  const Mesh ball = test::blob_mesh(1.0, 0.0, 60);
  Instance instance;
  instance.scale = 1.25;
  EXPECT_NEAR(look(ball, ball, instance).mean, 0.64, 0.001);
  instance.translation = {100, 0, 0};
  EXPECT_EQ(look(ball, ball, instance).mean, 0.0);
}

TEST(Silhouette, OfABoxHalfFilledIsWorstFromTheSideAndBestFromAbove) {
  const Mesh box = test::box_mesh(dvec3(-1), dvec3(1));
  const Mesh lower_half = test::box_mesh(dvec3(-1), dvec3(1, 0, 1));
  const Silhouette result = look(box, lower_half, Instance{}, {100, 200});
  EXPECT_LT(result.worst_direction.y, 0.1);
  for (const auto& [direction, iou] : result.views) {
    // A face of area A looks A |n · direction| large; a box shows three.
    const dvec3 d = glm::abs(direction);
    EXPECT_NEAR(iou, (0.5 * (d.x + d.z) + d.y) / (d.x + d.y + d.z), 0.01);
  }
}

TEST(Silhouette, OfTheTargetItselfIsOneWhereverItStands) {
  for (const double size : {1e-6, 1.0, 1e6}) {
    const Mesh target =
        test::box_mesh(size * dvec3(100, 200, 300), size * dvec3(101, 202.5, 300.25));
    const Silhouette result = look(target, target, Instance{});
    EXPECT_EQ(result.worst, 1.0);
    EXPECT_EQ(result.mean, 1.0);
  }
}

TEST(Silhouette, PictureShowsTheWorstViewUprightAndSaysWhatIsWhere) {
  // Missing: the upper half. Sticking out: the lowest fifth.
  const Mesh target = test::box_mesh(dvec3(-1), dvec3(1));
  const Mesh sculpture = test::box_mesh(dvec3(-1, -1.5, -1), dvec3(1, 0, 1));
  const Silhouette result = look(target, sculpture, Instance{}, {300, 100});
  EXPECT_LT(result.worst_direction.y, 0.05);
  const SilhouettePicture& picture = result.worst_picture;
  ASSERT_EQ(picture.pixels.size(), 10000U);
  EXPECT_EQ(picture.iou(), result.worst);
  const auto middle_of_row = [&](int row) { return picture.pixels[row * 100U + 50]; };
  EXPECT_EQ(middle_of_row(15), Pixel::target);
  EXPECT_EQ(middle_of_row(60), Pixel::both);
  EXPECT_EQ(middle_of_row(88), Pixel::sculpture);
}

TEST(Silhouette, WithoutInstancesIsNothing) {
  const Mesh target = test::box_mesh(dvec3(-1), dvec3(1));
  Status status;
  EXPECT_EQ(silhouette(target, InstanceIndex({}, {}), {}, status).mean, 0.0);
}

TEST(ViewDirections, AreUnitVectorsAboveTheGroundAndEvenlySpread) {
  const auto directions = view_directions(42);
  dvec3 sum(0.0);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    EXPECT_NEAR(glm::length(directions[i]), 1.0, 1e-15);
    EXPECT_GT(directions[i].y, 0.0);
    sum += directions[i];
    double nearest = 2.0;
    for (std::size_t j = 0; j < directions.size(); ++j) {
      if (j != i) {
        nearest = std::min(nearest, glm::distance(directions[i], directions[j]));
      }
    }
    EXPECT_GT(nearest, 0.3);  // 42 equal caps on half a sphere have a radius of 0.31
    EXPECT_LT(nearest, 0.5);
  }
  // The centroid of a half sphere is half way up.
  EXPECT_LT(glm::distance(sum / 42.0, dvec3(0, 0.5, 0)), 0.02);
}

}  // namespace
}  // namespace collage
