#include "audit/measures.h"

#include <string>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "base/error.h"
#include "support/meshes.h"

namespace collage {
namespace {

/// A few hundred rings and boxes, many of them in each other, in a blob.
class MeasuresTest : public testing::Test {
 protected:
  MeasuresTest() {
    Rng rng(101, 0);
    for (int i = 0; i < 300; ++i) {
      const dvec3 axis = test::random_point(rng, 1.0);
      Instance instance;
      instance.element = static_cast<std::uint32_t>(rng.below(2));
      instance.scale = 0.02 / (0.1 + rng.uniform());
      instance.rotation = glm::normalize(glm::dquat(0.5, axis.x, axis.y, axis.z));
      instance.translation = test::random_point(rng, 0.5);
      instances_.push_back(instance);
    }
    input_.target = &target_;
    input_.elements = {&ring_, &box_};
    input_.instances = instances_;
    input_.silhouette = {6, 60};
    input_.surface_distance.points = 500;
    input_.fill.points = 3000;
  }

  Mesh target_ = test::blob_mesh(1.0, 0.2, 16);
  Mesh ring_ = test::torus_mesh(1.0, 0.4, 16, 8);
  Mesh box_ = test::box_mesh(dvec3(-1), dvec3(1, 0.5, 0.3));
  std::vector<Instance> instances_;
  MeasureInput input_;
};

TEST_F(MeasuresTest, AreAllThereAndSoundForAMeshWithInstances) {
  Status status;
  const Measures measures = measure(input_, status);
  ASSERT_TRUE(measures.silhouette_iou && measures.surface_distance && measures.fill);
  ASSERT_TRUE(measures.contacts && measures.sizes && measures.orientations);
  EXPECT_GT(measures.silhouette_iou->worst, 0.0);
  EXPECT_GT(measures.silhouette_iou->mean, measures.silhouette_iou->worst);
  EXPECT_LT(measures.silhouette_iou->mean, 1.0);
  EXPECT_GT(measures.surface_distance->p95, measures.surface_distance->mean);
  EXPECT_GT(measures.fill->by_volume, *measures.fill->by_points.share());  // some overlap
  EXPECT_NEAR(measures.contacts->gap, 0.01 * bounding_box(target_).longest_side(), 1e-12);
  EXPECT_GT(measures.sizes->largest, 0.1);
  EXPECT_EQ(measures.kinds.counts[0] + measures.kinds.counts[1], 300U);
  EXPECT_TRUE(measures.kinds.clustering);
}

TEST_F(MeasuresTest, AreTheSameOnAnyNumberOfThreads) {
  Status status;
  const Measures many = measure(input_, status);
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const Measures one = measure(input_, status);
  EXPECT_EQ(many.silhouette_iou->mean, one.silhouette_iou->mean);
  EXPECT_EQ(many.silhouette_iou->worst_picture.pixels, one.silhouette_iou->worst_picture.pixels);
  EXPECT_EQ(many.surface_distance->mean, one.surface_distance->mean);
  EXPECT_EQ(many.surface_distance->histogram, one.surface_distance->histogram);
  EXPECT_EQ(many.fill->by_volume, one.fill->by_volume);
  EXPECT_EQ(many.fill->by_points.filled, one.fill->by_points.filled);
  EXPECT_EQ(many.fill->by_shell[3].filled, one.fill->by_shell[3].filled);
  EXPECT_EQ(many.contacts->clusters, one.contacts->clusters);
  EXPECT_EQ(many.contacts->floating_share, one.contacts->floating_share);
  EXPECT_EQ(many.sizes->power_law->exponent, one.sizes->power_law->exponent);
  EXPECT_EQ(many.orientations->evenness, one.orientations->evenness);
  EXPECT_EQ(many.kinds.clustering->z_score, one.kinds.clustering->z_score);
}

TEST_F(MeasuresTest, LeaveOutWhatNeedsTheTargetsMesh) {
  input_.target = nullptr;
  Status status;
  EXPECT_FALSE(measure(input_, status).contacts);
  input_.target_side = 2.0;
  const Measures measures = measure(input_, status);
  EXPECT_FALSE(measures.silhouette_iou || measures.surface_distance || measures.fill);
  EXPECT_EQ(measures.contacts->gap, 0.02);
  EXPECT_TRUE(measures.sizes && measures.orientations);
}

TEST_F(MeasuresTest, OfNoInstancesAreZeroOrNothing) {
  input_.instances = {};
  Status status;
  const Measures measures = measure(input_, status);
  EXPECT_EQ(measures.silhouette_iou->mean, 0.0);
  EXPECT_EQ(measures.fill->by_volume, 0.0);
  EXPECT_FALSE(measures.surface_distance || measures.contacts || measures.sizes ||
               measures.orientations || measures.kinds.clustering);
  EXPECT_EQ(measures.kinds.shares, (std::vector<double>{0.0, 0.0}));
}

/// Hears all updates and stops the work at the one that it is told to.
class Listener : public Status {
 public:
  explicit Listener(int stop_after) : stop_after_(stop_after) {}

  void update(double fraction, std::string_view detail) override {
    EXPECT_GE(fraction, fraction_);
    EXPECT_LE(fraction, 1.0);
    fraction_ = fraction;
    details_ += std::string(detail) + "\n";
    ++updates_;
  }
  [[nodiscard]] bool stop_requested() const override { return updates_ == stop_after_; }

  [[nodiscard]] int updates() const { return updates_; }
  [[nodiscard]] const std::string& details() const { return details_; }

 private:
  int stop_after_;
  int updates_ = 0;
  double fraction_ = 0.0;
  std::string details_;
};

TEST_F(MeasuresTest, SayHowFarTheyAreAndStopWhenAsked) {
  Listener listener(-1);
  measure(input_, listener);
  EXPECT_NE(listener.details().find("5 outlines"), std::string::npos);
  EXPECT_NE(listener.details().find("0 instances"), std::string::npos);
  for (int stop = 0; stop < listener.updates(); ++stop) {
    Listener impatient(stop);
    EXPECT_THROW(measure(input_, impatient), Interrupted);
    EXPECT_EQ(impatient.updates(), stop);
  }
}

}  // namespace
}  // namespace collage
