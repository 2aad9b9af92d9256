#pragma once

#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/status.h"
#include "render/process.h"

namespace collage {

/// The POV-Ray that renders.
struct Povray {
  std::filesystem::path program;
  /// As it says it: "3.7.0.10.unofficial".
  std::string version;
  /// Bubblewrap, for it to run in; none where that is missing or does not work here.
  std::optional<std::filesystem::path> sandbox{};
};

/// The POV-Ray named by the environment variable COLLAGE_POVRAY, else the one on PATH, in a sandbox
/// unless COLLAGE_SANDBOX is "no". Throws Error (outside program) where there is none, it does not
/// run, or it is older than 3.7. Takes a quarter of a second.
Povray find_povray(CommandRunner& runner, const Status& status);

/// Understands what a running POV-Ray 3.7 writes to its console.
class PovrayConsole {
 public:
  void read_line(std::string_view line);

  /// How much of the picture is done, 0 to 1; never falls. Parsing counts nothing, a radiosity
  /// pretrace as the first third.
  [[nodiscard]] double fraction() const { return fraction_; }
  /// The lines that are neither banner nor progress, the last few.
  [[nodiscard]] const std::deque<std::string>& remarks() const { return remarks_; }

 private:
  double fraction_ = 0.0;
  double pretrace_share_ = 0.0;
  bool past_banner_ = false;
  std::deque<std::string> remarks_;
};

/// Why POV-Ray failed, as one line of ours: "out/teapot/scene.pov:7: POV-Ray: Expected …".
/// `fatal_text` is what its option +GF wrote ("" where nothing was), `folder` where it ran.
Error povray_error(const std::filesystem::path& folder, int exit_code, std::string_view fatal_text,
                   const PovrayConsole& console);

}  // namespace collage
