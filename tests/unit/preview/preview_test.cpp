#include "preview/preview.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "preview/studio.h"
#include "support/meshes.h"

namespace collage {
namespace {

using glm::vec3;

std::optional<Texture> no_texture(const std::filesystem::path&) { return std::nullopt; }

/// A red box and, on top of it, a green one.
class PreviewTest : public ::testing::Test {
 protected:
  PreviewTest() {
    composition_.elements.push_back({"red", box_, "#ff0000", Finish::matt});
    composition_.elements.push_back({"green", box_, "#00ff00", Finish::ceramic});
    composition_.instances = instances_;
  }

  [[nodiscard]] PreviewPicture picture(const PreviewShown& shown = {}) const {
    return Preview(composition_, no_texture, shown).picture(shot_);
  }
  static vec3 at(const PreviewPicture& picture, double across, double down) {
    const int x = static_cast<int>(across * picture.width);
    const int y = static_cast<int>(down * picture.height);
    return picture.pixels.at(static_cast<std::size_t>(y * picture.width + x));
  }
  static bool is_red(const vec3& color) { return color.r > 0.2F && color.g < 0.1F * color.r; }
  static bool is_green(const vec3& color) { return color.g > 0.1F && color.r < 0.5F * color.g; }

  Mesh box_ = test::box_mesh({-1, -1, -1}, {1, 1, 1});
  const std::vector<Instance> instances_{{0, 1.0, {1, 0, 0, 0}, {0, 1, 0}},
                                         {1, 1.0, {1, 0, 0, 0}, {0, 3.2, 0}}};
  Composition composition_;
  /// Sides that are no multiples of a block's.
  PreviewShot shot_{{20, 10}, 61, 47, Framing::view};
};

TEST_F(PreviewTest, ShowsEachElementInItsColorInItsPlace) {
  const PreviewPicture seen = picture();
  ASSERT_EQ(seen.pixels.size(), 61U * 47U);
  EXPECT_TRUE(is_red(at(seen, 0.5, 0.7)));
  EXPECT_TRUE(is_green(at(seen, 0.5, 0.3)));
}

TEST_F(PreviewTest, ShowsPropsAtEveryStage) {
  Composition composition;
  composition.elements.push_back({"red", box_, "#ff0000", Finish::matt});
  composition.props.push_back({"green", box_, "#00ff00", Finish::matt});
  const std::vector<Instance> instances{{0, 1.0, {1, 0, 0, 0}, {0, 2.2, 0}}};
  composition.instances = instances;
  const PreviewPicture seen = Preview(composition, no_texture, {}).picture(shot_);
  EXPECT_TRUE(is_red(at(seen, 0.5, 0.3)));
  EXPECT_TRUE(is_green(at(seen, 0.5, 0.7)));
}

TEST_F(PreviewTest, ShowsTheBackdropBesideIt) {
  const PreviewPicture seen = picture();
  const dvec3 wanted = studio_backdrop(1.0 / 61 - 1.0, 1.0 - 1.0 / 47);
  EXPECT_LT(glm::distance(vec3(wanted), seen.pixels.front()), 2e-3F);
}

TEST_F(PreviewTest, ShowsStagesAndSingleElementsInTheSamePlace) {
  const PreviewPicture early = picture({0.5, std::nullopt});
  EXPECT_TRUE(is_red(at(early, 0.5, 0.7)));
  EXPECT_FALSE(is_green(at(early, 0.5, 0.3)));
  const PreviewPicture second = picture({1.0, 1});
  EXPECT_FALSE(is_red(at(second, 0.5, 0.7)));
  EXPECT_TRUE(is_green(at(second, 0.5, 0.3)));
}

TEST_F(PreviewTest, IsTheSameOnAnyNumberOfThreads) {
  const PreviewPicture many = picture();
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_TRUE(picture().pixels == many.pixels);
}

TEST_F(PreviewTest, HasNoNoiseOnAFlatFace) {
  shot_ = {{0, 0}, 320, 240, Framing::view};
  composition_.instances = std::span(instances_).first(1);
  const PreviewPicture seen = picture();
  const vec3 middle = at(seen, 0.5, 0.5);
  for (double across = 0.4; across < 0.6; across += 0.01) {
    EXPECT_LT(glm::distance(at(seen, across, 0.4), middle), 0.02F);
  }
}

TEST_F(PreviewTest, TakesColorsFromTextures) {
  box_.uvs = {{0.25, 0.5}, {0.75, 0.5}};
  box_.uv_triangles.assign(box_.triangles.size(), uvec3(0));
  Material material;
  material.texture = "blue.png";
  box_.materials = {material};
  composition_.elements.clear();
  composition_.elements.push_back({"blue", box_});
  composition_.instances = std::span(instances_).first(1);
  int reads = 0;
  const Preview preview(composition_, [&](const std::filesystem::path& path) {
    ++reads;
    EXPECT_EQ(path, "blue.png");
    return std::optional(Texture{2, 1, {vec3(0, 0, 1), vec3(0, 1, 0)}});
  });
  const vec3 seen = at(preview.picture(shot_), 0.5, 0.5);
  EXPECT_GT(seen.b, 0.1F);
  EXPECT_LT(seen.g, 0.5F * seen.b);
  EXPECT_EQ(reads, 1);
}

TEST(Texture, IsBilinearAndRepeats) {
  const Texture texture{2, 2, {vec3(0), vec3(1), vec3(2), vec3(3)}};
  EXPECT_FLOAT_EQ(texture.at({0.25, 0.75}).r, 0.0F);  // v counts from the bottom
  EXPECT_FLOAT_EQ(texture.at({0.75, 0.25}).r, 3.0F);
  EXPECT_FLOAT_EQ(texture.at({0.5, 0.5}).r, 1.5F);
  EXPECT_FLOAT_EQ(texture.at({-0.75, 7.75}).r, 0.0F);
  EXPECT_FLOAT_EQ(texture.at({0.0, 0.75}).r, 0.5F);
}

}  // namespace
}  // namespace collage
