#include "render/turntable.h"

#include "unit/render/stand_in_scene.h"
#include "unit/render/support.h"

namespace collage {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using testing::error_of;
using testing::FakeRunner;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using testing::plain_picture;
using testing::RecordingStatus;
using testing::TestFolder;

TEST(FrameRange, is_one_frame_or_two_ends) {
  EXPECT_EQ(parse_frame_range("5-12", 36).first, 5);
  EXPECT_EQ(parse_frame_range("5-12", 36).last, 12);
  EXPECT_EQ(parse_frame_range("7", 36).first, 7);
  EXPECT_EQ(parse_frame_range("7", 36).last, 7);
}

TEST(FrameRange, anything_else_is_an_error) {
  for (const char* text : {"", "-", "5-", "-5", "0-3", "12-5", "30-37", "a", "1-2-3", "1 - 2"}) {
    EXPECT_EQ(error_of([&] { parse_frame_range(text, 36); }),
              "'" + std::string(text) +
                  "' is no range of frames 1 to 36; write it as 5-12, or one frame as 7");
  }
}

TEST(TurntableFrames, are_numbered_with_the_digits_of_the_last) {
  EXPECT_EQ(turntable_frames("out", 36).front(), "out/turntable/frame-01.png");
  EXPECT_EQ(turntable_frames("out", 100).at(8), "out/turntable/frame-009.png");
  EXPECT_EQ(turntable_frames("out", 9).back(), "out/turntable/frame-9.png");
}

class TurntableByFake : public ::testing::Test {
 protected:
  void SetUp() override {
    testing::write_scene(folder_.path());
    turntable_.shot = testing::small_shot(0);
    turntable_.frames = 12;
  }
  std::vector<double> azimuths_;
  FakeRunner::Answer frame() {
    return {.exit_code = 0, .effect = [this](const Command& command) {
              const std::string job = read_file(command.folder / command.arguments[0].substr(2));
              azimuths_.push_back(std::stod(job.substr(job.find("Azimuth = ") + 10)));
              write_picture(command.folder / command.arguments[1].substr(2), plain_picture(64, 48));
            }};
  }
  TestFolder folder_;
  FakeRunner runner_;
  RecordingStatus status_;
  const Povray povray_{"/usr/bin/povray", "3.7.0"};
  Turntable turntable_;
};

TEST_F(TurntableByFake, frames_go_all_round_and_the_last_is_not_the_first) {
  runner_.answers.assign(12, frame());
  const RenderTools tools{runner_, povray_, 1, status_};
  EXPECT_EQ(render_turntable_frames(tools, folder_.path(), turntable_, {1, 12}).rendered, 12);
  EXPECT_THAT(azimuths_, ElementsAre(0, 30, 60, 90, 120, 150, 180, 210, 240, 270, 300, 330));
  EXPECT_EQ(status_.details.back(), "frame 12 of 12");
}

TEST_F(TurntableByFake, a_range_renders_its_frames_alone) {
  runner_.answers.assign(2, frame());
  const RenderTools tools{runner_, povray_, 1, status_};
  EXPECT_EQ(render_turntable_frames(tools, folder_.path(), turntable_, {2, 3}).rendered, 2);
  EXPECT_THAT(azimuths_, ElementsAre(30, 60));
  EXPECT_TRUE(fs::exists(folder_ / "turntable/frame-03.png"));
}

TEST_F(TurntableByFake, without_ffmpeg_there_is_a_gif_and_a_note) {
  runner_.answers.assign(12, frame());
  render_turntable({runner_, povray_, 1, status_}, folder_.path(), turntable_);
  EXPECT_TRUE(fs::exists(folder_ / "turntable/turntable.gif"));
  EXPECT_THAT(
      status_.notes,
      ElementsAre("no turntable.mp4 without ffmpeg; to have one, run: apt-get install ffmpeg"));
}

TEST_F(TurntableByFake, assembling_names_the_missing_frame) {
  EXPECT_THAT(error_of([&] { assemble_turntable(runner_, folder_.path(), turntable_, status_); }),
              HasSubstr("frame-01.png: no such file"));
}

TEST_F(TurntableByFake, numbers_out_of_range_are_errors) {
  turntable_.frames = 0;
  const auto error = [&] {
    return error_of([&] { assemble_turntable(runner_, folder_.path(), turntable_, status_); });
  };
  EXPECT_THAT(error(), HasSubstr("a turntable of 0 frames cannot be made"));
  turntable_.frames = 4;
  turntable_.frames_per_second = 0;
  EXPECT_THAT(error(), HasSubstr("choose 1 to 100"));
}

TEST_F(TurntableByFake, by_povray_and_ffmpeg_it_is_whole) {
  SystemRunner runner;
  if (!runner.find("povray") || !runner.find("ffmpeg")) {
    GTEST_SKIP() << "POV-Ray or ffmpeg is not installed";
  }
  turntable_.frames = 3;
  const Povray povray = find_povray(runner, status_);
  const RenderTools tools{runner, povray, 2, status_};
  EXPECT_EQ(render_turntable(tools, folder_.path(), turntable_).rendered, 3);
  EXPECT_EQ(render_turntable(tools, folder_.path(), turntable_).kept, 3);
  EXPECT_THAT(folder_.files(), ElementsAre("scene.pov", "studio.inc", "turntable/frame-1.png",
                                           "turntable/frame-2.png", "turntable/frame-3.png",
                                           "turntable/turntable.gif", "turntable/turntable.mp4"));
}

}  // namespace
}  // namespace collage
