#include "render/turntable.h"

#include <charconv>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "base/stage.h"
#include "render/film.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

std::size_t digits_of(int frames) { return std::to_string(frames).size(); }

std::string frame_name(int frame, int frames) {
  const std::string number = std::to_string(frame);
  return "frame-" + std::string(digits_of(frames) - number.size(), '0') + number + ".png";
}

std::optional<int> whole_number(std::string_view text) {
  int value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_number = result.ec == std::errc() && result.ptr == text.data() + text.size();
  return is_number ? std::optional(value) : std::nullopt;
}

void check(const Turntable& turntable) {
  if (turntable.frames < 1 || turntable.frames > 9999) {
    throw Error("a turntable of " + std::to_string(turntable.frames) + " frames cannot be made",
                "choose 1 to 9999 frames");
  }
  if (!(turntable.frames_per_second >= 1.0 && turntable.frames_per_second <= 100.0)) {
    throw Error("a film cannot run at " + std::to_string(turntable.frames_per_second) +
                    " frames per second",
                "choose 1 to 100");
  }
}

Shot frame_shot(const Turntable& turntable, int frame) {
  Shot shot = turntable.shot;
  shot.format = PictureFormat::png;
  shot.framing = Shot::Framing::all_round;
  shot.view.azimuth_degrees =
      std::fmod(shot.view.azimuth_degrees + 360.0 * (frame - 1) / turntable.frames, 360.0);
  return shot;
}

}  // namespace

FrameRange parse_frame_range(const std::string& text, int frames) {
  const std::size_t dash = text.find('-');
  const std::optional<int> first = whole_number(std::string_view(text).substr(0, dash));
  const std::optional<int> last =
      dash == std::string::npos ? first : whole_number(std::string_view(text).substr(dash + 1));
  if (!first || !last || *first < 1 || *last < *first || *last > frames) {
    throw Error("'" + text + "' is no range of frames 1 to " + std::to_string(frames),
                "write it as 5-12, or one frame as 7");
  }
  return {*first, *last};
}

std::vector<fs::path> turntable_frames(const fs::path& folder, int frames) {
  std::vector<fs::path> paths;
  for (int frame = 1; frame <= frames; ++frame) {
    paths.push_back(folder / "turntable" / frame_name(frame, frames));
  }
  return paths;
}

std::vector<PictureJob> turntable_jobs(const fs::path& folder, const Turntable& turntable,
                                       FrameRange range) {
  check(turntable);
  const std::vector<fs::path> paths = turntable_frames(folder, turntable.frames);
  std::vector<PictureJob> jobs;
  for (int frame = range.first; frame <= range.last; ++frame) {
    jobs.push_back({frame_shot(turntable, frame), paths.at(static_cast<std::size_t>(frame - 1))});
  }
  return jobs;
}

RenderCount render_turntable_frames(const RenderTools& tools, const fs::path& folder,
                                    const Turntable& turntable, FrameRange range) {
  return render_pictures(tools, folder, turntable_jobs(folder, turntable, range), "frame");
}

void assemble_turntable(CommandRunner& runner, const fs::path& folder, const Turntable& turntable,
                        Status& status) {
  check(turntable);
  const fs::path place = folder / "turntable";
  const Stage stage(status, "making the film");
  write_gif(turntable_frames(folder, turntable.frames), turntable.frames_per_second,
            place / "turntable.gif", status);
  if (!runner.find("ffmpeg")) {
    status.note("no turntable.mp4 without ffmpeg; to have one, run: apt-get install ffmpeg");
    return;
  }
  status.update(1.0, "turntable.mp4");
  const std::string pattern = "frame-%0" + std::to_string(digits_of(turntable.frames)) + "d.png";
  write_mp4(runner, pattern, turntable.frames, turntable.frames_per_second, place / "turntable.mp4",
            status);
}

RenderCount render_turntable(const RenderTools& tools, const fs::path& folder,
                             const Turntable& turntable) {
  const RenderCount count =
      render_turntable_frames(tools, folder, turntable, {1, turntable.frames});
  assemble_turntable(tools.runner, folder, turntable, tools.status);
  return count;
}

}  // namespace collage
