#include "scene/mesh_library.h"

#include <gtest/gtest.h>

#include "unit/scene/support.h"

namespace collage {
namespace {

using testing::error_of;
namespace fs = std::filesystem;

TEST(MeshLibrary, KnowsItsNamesFromPaths) {
  for (const char* name : {"toys:cup.obj", "a-b_c.2:x/y.obj", "toys:"}) {
    EXPECT_TRUE(names_library(name)) << name;
  }
  for (const char* path : {"cup.obj", "", ":cup.obj", "./toys:cup.obj", "../toys:cup.obj",
                           "a/toys:cup.obj", "/toys:cup.obj", "my toys:cup.obj", "..:cup.obj"}) {
    EXPECT_FALSE(names_library(path)) << path;
  }
}

class MeshLibraryFiles : public ::testing::Test {
 protected:
  MeshLibraryFiles() {
    folder.write("meshes/toys/cups/cup 1.obj", "");
    folder.write("meshes/secret.obj", "");
  }

  fs::path find(const std::string& text) const {
    return find_in_library(text, libraries, {"scene.toml", 3}, "target.mesh");
  }
  std::string error(const std::string& text) const {
    return error_of([&] { find(text); });
  }

  testing::TemporaryFolder folder;
  MeshLibraries libraries{folder.path() / "meshes", "unpack it"};
};

TEST_F(MeshLibraryFiles, AreFoundInTheLibrarysFolder) {
  EXPECT_EQ(find("toys:cups/cup 1.obj"), libraries.folder / "toys/cups/cup 1.obj");
  EXPECT_EQ(
      error("toys:cups/cup 2.obj"),
      "scene.toml:3: target.mesh: the mesh library 'toys' has no file 'cups/cup 2.obj'; check "
      "the path, which starts from the library's folder " +
          (libraries.folder / "toys").string());
}

TEST_F(MeshLibraryFiles, StayInTheLibrarysFolder) {
  fs::create_symlink(libraries.folder / "secret.obj", libraries.folder / "toys/link.obj");
  for (const std::string& path :
       {std::string("../secret.obj"), std::string("cups/../../secret.obj"), std::string("link.obj"),
        (libraries.folder / "secret.obj").string(), std::string("cups"), std::string(),
        std::string("cups\0", 5)}) {
    EXPECT_NE(error("toys:" + path), "") << path;
  }
}

TEST_F(MeshLibraryFiles, AreMissedWithARemedy) {
  EXPECT_EQ(error("tools:hammer.obj"),
            "scene.toml:3: target.mesh: there is no mesh library 'tools'; unpack it");
  libraries.folder.clear();
  EXPECT_EQ(error("toys:cups/cup 1.obj"),
            "scene.toml:3: target.mesh: there is no mesh library 'toys'; unpack it");
}

}  // namespace
}  // namespace collage
