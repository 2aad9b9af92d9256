#include "fitting/shape_cache.h"

#include <fstream>

#include <gtest/gtest.h>

#include "base/file.h"
#include "support/folder.h"
#include "support/meshes.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

void expect_same(const SphereCover& a, const SphereCover& b) {
  EXPECT_EQ(a.bulge, b.bulge);
  ASSERT_EQ(a.spheres.size(), b.spheres.size());
  for (std::size_t i = 0; i < a.spheres.size(); ++i) {
    EXPECT_EQ(a.spheres[i].center, b.spheres[i].center);
    EXPECT_EQ(a.spheres[i].radius, b.spheres[i].radius);
  }
}

void expect_same(const ShapeData& a, const ShapeData& b) {
  expect_same(a.coarse, b.coarse);
  expect_same(a.fine, b.fine);
  EXPECT_EQ(a.distances.first(), b.distances.first());
  EXPECT_EQ(a.distances.spacing(), b.distances.spacing());
  EXPECT_EQ(a.distances.size(), b.distances.size());
  EXPECT_EQ(a.distances.values(), b.distances.values());
}

std::vector<fs::path> files_in(const fs::path& folder) {
  return {fs::directory_iterator(folder), fs::directory_iterator()};
}

class ShapeCache : public testing::Test {
 protected:
  test::Folder folder_;
  Mesh mesh_ = test::box_mesh({-1.0, -0.6, -0.8}, {1.0, 0.6, 0.8});
  Element element_{mesh_};
  /// Measured, as there is no file yet.
  ShapeData measured_ = cached();

  [[nodiscard]] ShapeData cached() const { return cached_shape(mesh_, element_, folder_ / "c"); }
};

TEST_F(ShapeCache, GivesBackWhatWasMeasuredToTheBit) {
  ASSERT_EQ(files_in(folder_ / "c").size(), 1U);
  expect_same(measured_, cached());
}

/// What is read is what the file holds, and not measured again: of another mesh, here.
TEST_F(ShapeCache, ReadsTheFile) {
  const fs::path own = files_in(folder_ / "c").front();
  const Mesh other = test::blob_mesh(1.0, 0.2, 8);
  const Element element(other);
  const ShapeData of_other = cached_shape(other, element, folder_ / "other");
  fs::copy_file(files_in(folder_ / "other").front(), own, fs::copy_options::overwrite_existing);
  expect_same(of_other, cached());
}

TEST_F(ShapeCache, OtherMeshesHaveOtherFiles) {
  mesh_.positions[3] *= 0.999;
  const Element element(mesh_);
  cached_shape(mesh_, element, folder_ / "c");
  EXPECT_EQ(files_in(folder_ / "c").size(), 2U);
}

TEST_F(ShapeCache, MendsWhatIsCorrupt) {
  const fs::path file = files_in(folder_ / "c").front();
  const std::string whole = read_file(file);
  std::string flipped = whole;
  flipped[whole.size() / 2] = static_cast<char>(flipped[whole.size() / 2] ^ 1);
  for (const std::string& content :
       {whole.substr(0, 40), whole.substr(0, whole.size() - 1), flipped}) {
    write_file(file, content);
    expect_same(measured_, cached());
    EXPECT_EQ(read_file(file), whole);
  }
}

TEST_F(ShapeCache, DoesWithoutAFolder) {
  expect_same(measured_, cached_shape(mesh_, element_, {}));
  write_file(folder_ / "file", "");
  expect_same(measured_, cached_shape(mesh_, element_, folder_ / "file" / "c"));
}

}  // namespace
}  // namespace collage
