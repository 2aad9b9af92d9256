#include "render/film.h"

#include <cmath>
#include <memory>

#include <OpenImageIO/imageio.h>

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "render/picture_file.h"
#include "render/scratch.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

OIIO::ImageSpec gif_spec(const Picture& frame, double frames_per_second) {
  OIIO::ImageSpec spec(frame.width, frame.height, frame.channels, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("oiio:Movie", 1);
  spec.attribute("oiio:LoopCount", 0);
  const int rate[2] = {static_cast<int>(std::lround(frames_per_second * 1000)), 1000};
  spec.attribute("FramesPerSecond", OIIO::TypeRational, rate);
  return spec;
}

class GifWriter {
 public:
  GifWriter(const fs::path& output, std::size_t frames) : output_(output), frames_(frames) {
    if (!writer_) {
      fail();
    }
  }

  void append(const fs::path& path, const Picture& frame, const fs::path& file,
              double frames_per_second) {
    const OIIO::ImageSpec spec = gif_spec(frame, frames_per_second);
    if (specs_.empty()) {
      specs_.assign(frames_, spec);
      check(writer_->open(file.string(), static_cast<int>(frames_), specs_.data()));
    } else if (spec.width != specs_[0].width || spec.height != specs_[0].height) {
      throw Error({path}, "has another size than the first frame", "remove the frames of old runs");
    } else {
      check(writer_->open(file.string(), spec, OIIO::ImageOutput::AppendSubimage));
    }
    check(writer_->write_image(OIIO::TypeDesc::FLOAT, frame.values.data()));
  }

  void close() { check(writer_->close()); }

 private:
  void check(bool is_done) const {
    if (!is_done) {
      fail();
    }
  }
  [[noreturn]] void fail() const {
    throw Error({output_},
                "cannot be written: " + (writer_ ? writer_->geterror() : OIIO::geterror()),
                "check the folder's permissions and free space");
  }

  const fs::path& output_;
  std::size_t frames_;
  std::unique_ptr<OIIO::ImageOutput> writer_ = OIIO::ImageOutput::create("film.gif");
  std::vector<OIIO::ImageSpec> specs_;
};

}  // namespace

void write_gif(const std::vector<fs::path>& frames, double frames_per_second,
               const fs::path& output, Status& status) {
  const Scratch scratch(output.parent_path());
  GifWriter writer(output, frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (status.stop_requested()) {
      throw Interrupted();
    }
    status.update(static_cast<double>(i) / static_cast<double>(frames.size()),
                  output.filename().string());
    writer.append(frames[i], read_picture(frames[i]), scratch.path(".gif"), frames_per_second);
  }
  writer.close();
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
