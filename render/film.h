#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/status.h"
#include "render/process.h"

namespace collage {

/// Writes an animated GIF that plays for ever, whole or not at all. GIF counts time in hundredths
/// of a second, so that 12 frames a second become 12.5. Throws Error where a frame cannot be read,
/// or the frames differ in size. Holds one frame in memory.
void write_gif(const std::vector<std::filesystem::path>& frames, double frames_per_second,
               const std::filesystem::path& output, Status& status);

/// Writes an MP4 (H.264, 4:2:0, BT.709) by ffmpeg, whole or not at all, from the numbered frames
/// "frame-%02d.png" of the folder where `output` goes, counted from 1. An odd width or height loses
/// its last column or row, as the format asks for even ones. Equal frames give equal bytes. Throws
/// Error (outside program) where ffmpeg fails; whether it is there is the caller's question.
void write_mp4(CommandRunner& runner, const std::string& frame_pattern, int frames,
               double frames_per_second, const std::filesystem::path& output, const Status& status);

}  // namespace collage
