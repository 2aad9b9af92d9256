#include "scene/copy_inputs.h"

#include <gmock/gmock.h>

#include "geometry/mesh_file.h"
#include "unit/scene/support.h"

namespace collage {
namespace {

using testing::RecordingStatus;
using testing::TemporaryFolder;

TEST(CopyInputs, KeepsRelativeNames) {
  const TemporaryFolder folder;
  RecordingStatus status;
  const auto mesh = folder.write("in/cup.obj", "mesh");
  const Sculpture::Input input = copy_inputs({mesh, folder.write("in/cup.mtl", "materials"),
                                              folder.write("in/pictures/wood.png", "picture")},
                                             folder.path() / "out", "element-0", status);
  EXPECT_EQ(input.path, "meshes/element-0/cup.obj");
  EXPECT_EQ(input.sha256, sha256("mesh"));
  const auto copies = folder.path() / "out/meshes/element-0";
  EXPECT_EQ(read_file(copies / "cup.obj"), "mesh");
  EXPECT_EQ(read_file(copies / "cup.mtl"), "materials");
  EXPECT_EQ(read_file(copies / "pictures/wood.png"), "picture");
  EXPECT_TRUE(status.notes.empty());
}

TEST(CopyInputs, TakesTheCreditBesideTheInput) {
  const TemporaryFolder folder;
  RecordingStatus status;
  const auto mesh = folder.write("in/cup.obj", "mesh");
  folder.write("in/cup.credit.json",
               R"({"title": "Cup", "author": "A", "licence": "CC0", "link": ""})");
  const auto input = copy_inputs({mesh}, folder.path() / "out", "target", status);
  ASSERT_TRUE(input.credit);
  EXPECT_EQ(input.credit->title, "Cup");
}

TEST(CopyInputs, StaysInTheFolderOfTheInput) {
  const TemporaryFolder folder;
  RecordingStatus status;
  const auto mesh = folder.write("in/a/cup.obj", "mesh");
  copy_inputs({mesh, folder.path() / "in/a/../cup.mtl"}, folder.path() / "out", "target", status);
  ASSERT_EQ(status.notes.size(), 1U);
  EXPECT_THAT(status.notes[0], ::testing::HasSubstr("and is not copied"));
}

TEST(CopyInputs, TakesItsOwnCopies) {
  const TemporaryFolder folder;
  RecordingStatus status;
  const auto mesh = folder.write("meshes/target/cup.obj", "mesh");
  EXPECT_EQ(copy_inputs({mesh}, folder.path(), "target", status).path, "meshes/target/cup.obj");
  EXPECT_EQ(read_file(mesh), "mesh");
}

TEST(CopyInputs, WritesWhatWasMade) {
  const TemporaryFolder folder;
  const Sculpture::Input input =
      write_input(testing::cube(), "letters", folder.path(), "element-3");
  EXPECT_EQ(input.path, "meshes/element-3/letters.obj");
  EXPECT_EQ(input.sha256, sha256(read_file(folder.path() / input.path)));
  RecordingStatus status;
  EXPECT_EQ(read_obj(folder.path() / input.path, status).mesh.positions, testing::cube().positions);
}

}  // namespace
}  // namespace collage
