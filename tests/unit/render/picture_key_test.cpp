#include "render/picture_key.h"

#include "unit/render/stand_in_scene.h"
#include "unit/render/support.h"

namespace collage {
namespace {

using testing::small_shot;
using testing::TestFolder;
using testing::write_scene;

class PictureKey : public ::testing::Test {
 protected:
  void SetUp() override {
    write_scene(folder_.path(), "// uses \"texture-0.png\"\n");
    write_file(folder_ / "texture-0.png", "one");
  }
  std::string digest() { return scene_digest(folder_.path()); }
  TestFolder folder_;
};

TEST_F(PictureKey, follows_whatever_povray_reads) {
  const std::string before = digest();
  for (const char* name : {"scene.pov", "studio.inc", "texture-0.png"}) {
    const std::string content = read_file(folder_ / name);
    write_file(folder_ / name, content + "\n");
    EXPECT_NE(digest(), before) << name;
    write_file(folder_ / name, content);
  }
  EXPECT_EQ(digest(), before);
}

TEST_F(PictureKey, takes_no_notice_of_the_rest) {
  const std::string before = digest();
  for (const char* name : {"report.json", "still.png", "stills/front.png", ".collage-1-0.pov"}) {
    write_file(folder_ / name, "any");
  }
  EXPECT_EQ(digest(), before);
}

TEST_F(PictureKey, follows_the_shot_and_the_version) {
  const Povray povray{"/usr/bin/povray", "3.7.0"};
  const std::string key = picture_key("digest", small_shot(0), povray);
  EXPECT_EQ(key.size(), 64U);
  EXPECT_EQ(key, picture_key("digest", small_shot(0), {"/opt/povray", "3.7.0"}));
  EXPECT_NE(key, picture_key("digest", small_shot(1), povray));
  EXPECT_NE(key, picture_key("other", small_shot(0), povray));
  EXPECT_NE(key, picture_key("digest", small_shot(0), {"/usr/bin/povray", "3.8.0"}));
  Shot wide = small_shot(0);
  wide.width = 65;
  EXPECT_NE(key, picture_key("digest", wide, povray));
}

}  // namespace
}  // namespace collage
