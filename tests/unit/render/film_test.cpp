#include "render/film.h"

#include "unit/render/support.h"

namespace collage {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::ElementsAre;
using testing::error_of;
using testing::FakeRunner;
using ::testing::HasSubstr;
using testing::plain_picture;
using testing::RecordingStatus;
using testing::TestFolder;

class Film : public ::testing::Test {
 protected:
  void write_frames(int frames, int width = 63, int height = 47) {
    for (int i = 1; i <= frames; ++i) {
      frames_.push_back(folder_ / ("frame-" + std::to_string(i) + ".png"));
      write_picture(frames_.back(), plain_picture(width, height, 0.2F * static_cast<float>(i)));
    }
  }
  TestFolder folder_;
  std::vector<fs::path> frames_;
  RecordingStatus status_;
};

TEST_F(Film, gif_plays_for_ever_and_is_the_same_each_time) {
  write_frames(3);
  write_gif(frames_, 12.0, folder_ / "a.gif", status_);
  write_gif(frames_, 12.0, folder_ / "b.gif", status_);
  const std::string gif = read_file(folder_ / "a.gif");
  EXPECT_EQ(gif, read_file(folder_ / "b.gif"));
  EXPECT_THAT(gif, ::testing::StartsWith("GIF89a"));
  EXPECT_THAT(gif, HasSubstr("NETSCAPE2.0"));
  EXPECT_EQ(folder_.files().size(), 5U) << "no temporary files";
}

TEST_F(Film, gif_of_mixed_sizes_or_broken_frames_is_an_error_and_leaves_the_old_one) {
  write_frames(1);
  write_frames(2, 10, 10);
  write_file(folder_ / "a.gif", "old");
  const auto error = [&] {
    return error_of([&] { write_gif(frames_, 12.0, folder_ / "a.gif", status_); });
  };
  fs::remove(frames_[0]);
  EXPECT_THAT(error(), HasSubstr("frame-1.png: no such file"));
  write_picture(frames_[0], plain_picture(63, 47));
  EXPECT_THAT(error(), HasSubstr("frame-2.png: has another size than the first frame"));
  EXPECT_EQ(read_file(folder_ / "a.gif"), "old");
}

TEST_F(Film, mp4_of_odd_size_is_the_same_each_time) {
  SystemRunner runner;
  if (!runner.find("ffmpeg")) {
    GTEST_SKIP() << "ffmpeg is not installed";
  }
  write_frames(3);
  write_mp4(runner, "frame-%01d.png", 3, 12.0, folder_ / "a.mp4", status_);
  write_mp4(runner, "frame-%01d.png", 3, 12.0, folder_ / "b.mp4", status_);
  const std::string film = read_file(folder_ / "a.mp4");
  EXPECT_GT(film.size(), 500U);
  EXPECT_EQ(film, read_file(folder_ / "b.mp4"));
  EXPECT_LT(film.find("moov"), film.find("mdat")) << "can be played while it loads";
  EXPECT_EQ(folder_.files().size(), 5U);
}

TEST_F(Film, mp4_runs_in_the_folder_with_plain_names) {
  FakeRunner runner;
  runner.answers = {{.lines = {"x264 says no"}, .exit_code = 1}};
  EXPECT_EQ(
      error_of([&] { write_mp4(runner, "frame-%02d.png", 36, 12.0, folder_ / "a.mp4", status_); }),
      (folder_ / "a.mp4").string() +
          ": ffmpeg failed with exit code 1: x264 says no; the frames are there; the same "
          "command tries again");
  EXPECT_EQ(runner.commands.at(0).folder, folder_.path());
  EXPECT_THAT(runner.commands[0].arguments, Contains("frame-%02d.png"));
  EXPECT_THAT(folder_.files(), ElementsAre());
}

}  // namespace
}  // namespace collage
