#include "render/film.h"

#include <memory>

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "render/imaging.h"
#include "render/scratch.h"

namespace collage {

namespace fs = std::filesystem;

void write_gif(const std::vector<fs::path>& frames, double frames_per_second,
               const fs::path& output, Status& status) {
  const Scratch scratch(output.parent_path());
  const std::unique_ptr<Imaging::Film> film =
      imaging().film(scratch.path(".gif"), frames.size(), frames_per_second, output);
  int width = 0;
  int height = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (status.stop_requested()) {
      throw Interrupted();
    }
    status.update(static_cast<double>(i) / static_cast<double>(frames.size()),
                  output.filename().string());
    const Picture frame = read_picture(frames[i]);
    if (i == 0) {
      width = frame.width;
      height = frame.height;
    } else if (frame.width != width || frame.height != height) {
      throw Error({frames[i]}, "has another size than the first frame",
                  "remove the frames of old runs");
    }
    film->append(frame);
  }
  film->close();
  move_into_place(scratch.path(".gif"), output);
}

void write_mp4(CommandRunner& runner, const std::string& frame_pattern, int frames,
               double frames_per_second, const fs::path& output, const Status& status) {
  const Scratch scratch(output.parent_path());
  const std::string filter =
      "crop=trunc(iw/2)*2:trunc(ih/2)*2:0:0,scale=out_color_matrix=bt709:out_range=tv,"
      "format=yuv420p";
  const Command command{.program = "ffmpeg",
                        .arguments = {"-nostdin",
                                      "-loglevel",
                                      "error",
                                      "-framerate",
                                      number_text(frames_per_second),
                                      "-start_number",
                                      "1",
                                      "-i",
                                      frame_pattern,
                                      "-frames:v",
                                      std::to_string(frames),
                                      "-vf",
                                      filter,
                                      "-c:v",
                                      "libx264",
                                      "-crf",
                                      "18",
                                      "-preset",
                                      "slow",
                                      "-colorspace",
                                      "bt709",
                                      "-color_primaries",
                                      "bt709",
                                      "-color_trc",
                                      "bt709",
                                      "-fflags",
                                      "+bitexact",
                                      "-flags:v",
                                      "+bitexact",
                                      "-threads",
                                      "1",
                                      "-movflags",
                                      "+faststart",
                                      "-f",
                                      "mp4",
                                      scratch.name(".mp4")},
                        .folder = output.parent_path()};
  const CommandResult result = run_command(runner, command, status);
  if (result.exit_code != 0) {
    throw Error::outside_program(output.string() + ": ffmpeg failed with exit code " +
                                     std::to_string(result.exit_code) +
                                     (result.lines.empty() ? "" : ": " + result.lines.back()),
                                 "the frames are there; the same command tries again");
  }
  move_into_place(scratch.path(".mp4"), output);
}

}  // namespace collage
