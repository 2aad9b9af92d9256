#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "render/render_pictures.h"

namespace collage {

/// A film of the sculpture turning once: frame k of n is seen from azimuth 360 (k - 1) / n degrees.
struct Turntable {
  /// Size, template, quality and elevation of every frame; its azimuth is that of the first.
  Shot shot;
  int frames = 36;
  double frames_per_second = 12.0;
};

/// Frames counted from 1, both ends included.
struct FrameRange {
  int first;
  int last;
};

/// "5-12" or "7", within 1 … frames. Throws Error for anything else.
FrameRange parse_frame_range(const std::string& text, int frames);

/// <folder>/turntable/frame-01.png …, numbered with as many digits as the last one has.
std::vector<std::filesystem::path> turntable_frames(const std::filesystem::path& folder,
                                                    int frames);

/// The pictures of those frames.
std::vector<PictureJob> turntable_jobs(const std::filesystem::path& folder,
                                       const Turntable& turntable, FrameRange range);

/// Renders frames; see render_pictures() for what is kept, thrown and cleaned up. Several machines
/// may render ranges of one folder at once.
RenderCount render_turntable_frames(const RenderTools& tools, const std::filesystem::path& folder,
                                    const Turntable& turntable, FrameRange range);

/// Makes turntable/turntable.gif and, where ffmpeg is installed, turntable/turntable.mp4 of all
/// frames. Throws Error where a frame is missing or cut short.
void assemble_turntable(CommandRunner& runner, const std::filesystem::path& folder,
                        const Turntable& turntable, Status& status);

/// All frames, then the films.
RenderCount render_turntable(const RenderTools& tools, const std::filesystem::path& folder,
                             const Turntable& turntable);

}  // namespace collage
