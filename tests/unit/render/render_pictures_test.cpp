#include "render/render_pictures.h"

#include <thread>

#include <signal.h>
#include <sys/wait.h>

#include "base/memory.h"
#include "base/stopwatch.h"
#include "unit/render/stand_in_scene.h"
#include "unit/render/support.h"

namespace collage {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using testing::cut_in_half;
using testing::error_of;
using testing::FakeRunner;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::plain_picture;
using testing::RecordingStatus;
using testing::small_shot;
using testing::TestFolder;
using testing::write_scene;

bool has_argument(const Command& command, const std::string& argument) {
  return std::ranges::count(command.arguments, argument) > 0;
}

/// Does what POV-Ray does: leaves the picture that the arguments ask for.
void leave_picture(const Command& command) {
  for (const std::string& argument : command.arguments) {
    if (argument.starts_with("+O")) {
      write_picture(command.folder / argument.substr(2), plain_picture(64, 48));
    }
  }
}

class RenderByFake : public ::testing::Test {
 protected:
  void SetUp() override { write_scene(folder_.path()); }

  RenderCount render(int pictures, int threads = 3) {
    std::vector<PictureJob> jobs;
    for (int i = 0; i < pictures; ++i) {
      jobs.push_back({small_shot(10.0 * i), folder_ / ("stills/" + std::to_string(i) + ".png")});
    }
    return render_pictures({runner_, povray_, threads, status_}, folder_.path(), jobs, "frame");
  }
  void answer(const FakeRunner::Answer& answer, int times = 1) {
    runner_.answers.insert(runner_.answers.end(), static_cast<std::size_t>(times), answer);
  }
  std::vector<std::string> hidden_files() const {
    std::vector<std::string> names = folder_.files();
    std::erase_if(names, [](const auto& name) { return name.find(".collage-") == name.npos; });
    return names;
  }

  TestFolder folder_;
  FakeRunner runner_;
  RecordingStatus status_;
  const Povray povray_{"/usr/bin/povray", "3.7.0"};
  const FakeRunner::Answer good_{.exit_code = 0, .effect = leave_picture};
};

TEST_F(RenderByFake, one_picture_gets_all_threads) {
  answer(good_);
  const RenderCount count = render(1);
  EXPECT_EQ(count.rendered, 1);
  EXPECT_EQ(runner_.commands.size(), 1U);
  EXPECT_TRUE(has_argument(runner_.commands[0], "+WT3"));
  EXPECT_EQ(runner_.commands[0].folder, folder_.path());
}

TEST_F(RenderByFake, several_pictures_get_a_thread_each_and_one_waits) {
  answer(good_, 5);
  EXPECT_EQ(render(5).rendered, 5);
  EXPECT_EQ(runner_.most_at_once, 4U);
  for (const Command& command : runner_.commands) {
    EXPECT_TRUE(has_argument(command, "+WT1"));
  }
  EXPECT_THAT(hidden_files(), ::testing::IsEmpty());
  EXPECT_THAT(folder_.files(), Contains("stills/4.png"));
}

TEST_F(RenderByFake, one_thread_has_one_picture_at_a_time) {
  answer(good_, 3);
  EXPECT_EQ(render(3, 1).rendered, 3);
  EXPECT_EQ(runner_.most_at_once, 1U);
}

TEST_F(RenderByFake, memory_is_divided_among_those_that_run_at_once) {
  limit_memory(std::uint64_t{8} << 30);
  answer(good_, 6);
  render(5);
  fs::remove(folder_ / "stills/0.png");
  render(1);
  EXPECT_EQ(runner_.commands[0].memory_bytes, std::uint64_t{2} << 30);
  EXPECT_EQ(runner_.commands[5].memory_bytes, std::uint64_t{8} << 30);
  limit_memory(1'000'000);
  answer(good_);
  fs::remove(folder_ / "stills/0.png");
  render(1);
  EXPECT_EQ(runner_.commands[6].memory_bytes, std::uint64_t{1} << 30);
  limit_memory(0);
}

TEST_F(RenderByFake, povray_runs_in_the_sandbox) {
  const Povray povray{"/usr/bin/povray", "3.7.0", "/usr/bin/bwrap"};
  answer(good_);
  const std::vector<PictureJob> jobs = {{small_shot(0.0), folder_ / "a.png"}};
  render_pictures({runner_, povray, 1, status_}, folder_.path(), jobs);
  EXPECT_EQ(runner_.commands.at(0).program, "/usr/bin/bwrap");
  EXPECT_TRUE(has_argument(runner_.commands[0], "/usr/bin/povray"));
}

TEST_F(RenderByFake, what_is_there_is_kept_and_the_rest_finished) {
  answer(good_, 3);
  render(3);
  cut_in_half(folder_ / "stills/0.png");
  write_picture(folder_ / "stills/2.png", plain_picture(64, 48));  // without our key
  answer(good_, 2);
  const RenderCount count = render(3);
  EXPECT_EQ(count.rendered, 2);
  EXPECT_EQ(count.kept, 1);
  EXPECT_EQ(render(3).kept, 3);
}

TEST_F(RenderByFake, progress_counts_pictures_and_parts_of_them) {
  FakeRunner::Answer half = good_;
  half.lines = {"Rendered 1 of 2 pixels (50%)"};
  answer(half, 2);
  render(2);
  EXPECT_THAT(status_.stages, ::testing::ElementsAre("rendering"));
  EXPECT_EQ(status_.ended, 1);
  EXPECT_THAT(status_.details, ::testing::ElementsAre("frame 1 of 2", "frame 2 of 2"));
  EXPECT_THAT(status_.fractions, ::testing::ElementsAre(0.5, 0.75));
}

TEST_F(RenderByFake, a_failure_ends_the_others_and_leaves_no_temporary_files) {
  FakeRunner::Answer endless;
  endless.never_ends = true;
  answer(endless);
  answer({.lines = {"==== [Parsing...] ====", "Cannot go on.", "Render failed"}, .exit_code = 1});
  EXPECT_EQ(error_of([&] { render(2); }),
            folder_.path().string() +
                ": POV-Ray failed with exit code 1: Cannot go on. / Render "
                "failed; check the folder's permissions and free space");
  EXPECT_EQ(runner_.stopped, 1U);
  EXPECT_THAT(hidden_files(), ::testing::IsEmpty());
}

TEST_F(RenderByFake, success_without_a_picture_is_a_failure) {
  answer({});
  EXPECT_THAT(error_of([&] { render(1); }), HasSubstr("POV-Ray left no whole picture"));
}

TEST_F(RenderByFake, ctrl_c_ends_povray_and_leaves_no_temporary_files) {
  FakeRunner::Answer endless;
  endless.never_ends = true;
  endless.effect = leave_picture;
  answer(endless, 2);
  status_.stops_after = 3;
  EXPECT_THROW(render(2), Interrupted);
  EXPECT_EQ(runner_.stopped, 2U);
  EXPECT_THAT(hidden_files(), ::testing::IsEmpty());
  EXPECT_FALSE(fs::exists(folder_ / "stills/0.png"));
}

TEST_F(RenderByFake, says_what_is_missing_before_anything_runs) {
  fs::remove(folder_ / "scene.pov");
  EXPECT_EQ(
      error_of([&] { render(1); }),
      folder_.path().string() + ": there is no scene.pov here; make it with: collage pack SCENE");
  EXPECT_TRUE(runner_.commands.empty());
}

class RenderByPovray : public RenderByFake {
 protected:
  void SetUp() override {
    RenderByFake::SetUp();
    if (!system_.find("povray")) {
      GTEST_SKIP() << "POV-Ray is not installed";
    }
    real_povray_ = find_povray(system_, status_);
  }

  RenderCount render(const std::vector<PictureJob>& jobs, int threads = 2) {
    return render_pictures({system_, real_povray_, threads, status_}, folder_.path(), jobs);
  }
  std::vector<PictureJob> two_jobs() const {
    return {{small_shot(0), folder_ / "stills/a.png"}, {small_shot(90), folder_ / "stills/b.png"}};
  }

  SystemRunner system_;
  Povray real_povray_;
};

TEST_F(RenderByPovray, views_differ_and_threads_do_not_matter) {
  EXPECT_EQ(render(two_jobs()).rendered, 2);
  const Picture a = read_picture(folder_ / "stills/a.png");
  EXPECT_EQ(a.width, 64);
  EXPECT_EQ(a.height, 48);
  EXPECT_NE(a.values, read_picture(folder_ / "stills/b.png").values);
  const std::string bytes = read_file(folder_ / "stills/a.png");
  fs::remove(folder_ / "stills/a.png");
  EXPECT_EQ(render({two_jobs()[0]}, 1).rendered, 1);
  EXPECT_EQ(read_file(folder_ / "stills/a.png"), bytes);
  EXPECT_THAT(hidden_files(), ::testing::IsEmpty());
}

TEST_F(RenderByPovray, an_exr_is_float_and_kept_too) {
  PictureJob job{small_shot(0), folder_ / "stills/a.exr"};
  job.shot.format = PictureFormat::exr;
  EXPECT_EQ(render({job}).rendered, 1);
  EXPECT_EQ(read_picture(job.output).format, PictureFormat::exr);
  EXPECT_EQ(render({job}).kept, 1);
}

TEST_F(RenderByPovray, a_changed_scene_template_or_shot_renders_again) {
  render(two_jobs());
  EXPECT_EQ(render(two_jobs()).kept, 2);
  write_file(folder_ / "studio.inc", read_file(folder_ / "studio.inc") + "// changed\n");
  EXPECT_EQ(render(two_jobs()).rendered, 2);
  std::vector<PictureJob> jobs = two_jobs();
  jobs[0].shot.quality = Quality::standard;
  EXPECT_EQ(render(jobs).rendered, 1);
}

TEST_F(RenderByPovray, a_syntax_error_becomes_one_line_with_its_place) {
  write_file(folder_ / "scene.pov", "#version 3.7;\n#include Template\n\nspher { 0, 1 }\n");
  const std::string error = error_of([&] { render(two_jobs()); });
  EXPECT_EQ(error, (folder_ / "scene.pov").string() +
                       ":4: POV-Ray: Expected 'object or directive', undeclared identifier 'spher' "
                       "found instead; mend the template, or make the scene again");
  EXPECT_THAT(hidden_files(), ::testing::IsEmpty());
}

TEST_F(RenderByPovray, folders_with_spaces_and_umlauts_will_do) {
  const fs::path folder = folder_ / "größe 1 'a'";
  write_scene(folder);
  const PictureJob job{small_shot(0), folder / "bild 1.png"};
  const std::vector<PictureJob> jobs = {job};
  render_pictures({system_, real_povray_, 1, status_}, folder, jobs);
  EXPECT_TRUE(fs::exists(job.output));
}

TEST_F(RenderByPovray, after_kill_9_the_same_call_finishes_the_rest) {
  testing::write_slow_scene(folder_.path());
  std::vector<PictureJob> jobs = two_jobs();
  const pid_t child = ::fork();
  if (child == 0) {
    SystemRunner runner;
    render_pictures({runner, real_povray_, 1, status_}, folder_.path(), jobs);
    ::_exit(0);
  }
  const Stopwatch watch;
  while (hidden_files().size() < 3 && watch.seconds() < 20) {  // lock, job and state or picture
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  std::this_thread::sleep_for(std::chrono::milliseconds(200));  // POV-Ray dies with it
  EXPECT_THAT(hidden_files(), Not(::testing::IsEmpty()));
  write_scene(folder_.path());
  EXPECT_EQ(render(jobs).rendered, 2);
  EXPECT_THAT(hidden_files(), ::testing::IsEmpty());
}

TEST_F(RenderByPovray, ctrl_c_leaves_nothing_half_written) {
  testing::write_slow_scene(folder_.path());
  status_.stops_after = 20;
  EXPECT_THROW(render(two_jobs()), Interrupted);
  EXPECT_THAT(hidden_files(), ::testing::IsEmpty());
  EXPECT_FALSE(fs::exists(folder_ / "stills/a.png"));
}

}  // namespace
}  // namespace collage
