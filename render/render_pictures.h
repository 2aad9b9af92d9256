#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "base/status.h"
#include "render/povray.h"
#include "render/process.h"
#include "render/shot.h"

namespace collage {

/// Text that POV-Ray reads before the scene in `folder`: declarations that save it work and change
/// nothing in the picture. May be empty.
using Prologue = std::function<std::string(const std::filesystem::path& folder, const Shot& shot)>;

/// What rendering works with. `threads` ≥ 1: POV-Ray's threads, or how many single-threaded
/// POV-Rays it takes to keep them at work.
struct RenderTools {
  CommandRunner& runner;
  const Povray& povray;
  int threads;
  Status& status;
  Prologue prologue{};
};

struct PictureJob {
  Shot shot;
  std::filesystem::path output;
};

struct RenderCount {
  int rendered = 0;
  /// Pictures that were there already, whole and of this very scene.
  int kept = 0;
};

/// Has POV-Ray make the pictures of the scene in `folder`, in the order given; each appears under
/// its name when it is whole. One picture is rendered by all threads, several by single-threaded
/// POV-Rays, one more at a time than there are threads, as each idles for half a second when it
/// comes and goes; with one thread, one at a time. What is there already is kept, so that the same
/// call after a kill finishes the rest. Progress counts in `noun`s: "frame 12 of 36".
/// Throws Error where the scene, a shot or POV-Ray fails, Interrupted on Ctrl-C; both leave no
/// temporary files and end every POV-Ray.
RenderCount render_pictures(const RenderTools& tools, const std::filesystem::path& folder,
                            std::span<const PictureJob> jobs, std::string_view noun = "picture");

}  // namespace collage
