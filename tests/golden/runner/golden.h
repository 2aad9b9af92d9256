#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"
#include "render/compare.h"
#include "render/process.h"

namespace collage {

/// A golden picture. Its folder holds
/// - command: run by bash in a copy of the folder, leaves picture.png; `collage` is the program. It
///   renders with one thread, as two may give a pixel another level;
/// - reference.png: what the picture must look like;
/// - tolerance: where the default thresholds do not do, see read_tolerance();
/// - whatever else the command reads.
struct GoldenCase {
  std::string name;
  std::filesystem::path folder;
  Thresholds thresholds;
};

/// Those of the given names among the folders of `cases` that hold a command, all where none is
/// given, sorted by name. Throws Error where there is none of a name, or none at all.
std::vector<GoldenCase> find_golden_cases(const std::filesystem::path& cases,
                                          const std::vector<std::string>& names);

/// Lines "fail 0.004", "failing-share 0.0002" or "hard-fail 0.012" in place of the defaults, and a
/// comment (#) that gives the reason. A missing file: the defaults. Throws Error where a line is
/// anything else or the reason is missing.
Thresholds read_tolerance(const std::filesystem::path& file);

struct GoldenRun {
  enum class Update { no, yes };

  std::filesystem::path program;  // collage
  std::filesystem::path cases;
  /// Each case leaves what it made in the folder of its name, a report page lies beside them:
  /// index.html, or <name>.html where one case alone is named.
  std::filesystem::path output;
  std::vector<std::string> names;
  Update update = Update::no;
};

/// Makes the pictures, as many at once as there are processors, and lays them over their
/// references. Says by lines what fails, where it is kept, and how the references are rewritten.
/// With Update::yes the references of those that fail are rewritten, but never where the
/// environment has CI set. Returns an exit code: 0 where all pass or were rewritten, 1 where not.
/// Throws Error for bad input and Interrupted.
int run_golden(const GoldenRun& run, CommandRunner& runner, Status& status,
               const std::function<void(std::string_view)>& say);

}  // namespace collage
