#include <algorithm>
#include <cstdio>
#include <future>

#include <fmt/format.h>

#include "base/error.h"
#include "base/file.h"
#include "base/folder_lock.h"
#include "base/stage.h"
#include "base/text.h"
#include "cli/commands.h"
#include "cli/finished_folder.h"
#include "cli/pack_scene.h"
#include "cli/preview_picture.h"
#include "cli/render_outputs.h"
#include "cli/scene_arguments.h"
#include "cli/sweep.h"
#include "render/contact_sheet.h"
#include "render/imaging.h"
#include "scene/json_text.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_trials = 1000;

/// The folder named, or that of the scene named, packed now.
fs::path folder_of(const PreviewArguments& arguments, Terminal& terminal) {
  if (fs::exists(fs::path(arguments.scene.scene) / "sculpture.json")) {
    return arguments.scene.scene;
  }
  const Scene scene = read_scene_with(arguments.scene);
  const fs::path folder = output_folder(arguments.scene, scene);
  const FolderLock lock(folder, FolderLock::Kind::alone);
  pack_scene(scene, command_text(arguments.scene, scene), folder, terminal);
  return folder;
}

/// One combination of a sweep.
struct Trial {
  std::vector<std::string> settings;
  Scene scene;
  fs::path folder;
  /// Nothing where it could not be packed.
  std::optional<Report> report;
  std::string problem;

  [[nodiscard]] fs::path picture() const { return folder / "preview.png"; }
};

std::vector<SweepOption> options_of(const SweepArguments& arguments) {
  std::vector<SweepOption> options;
  for (const std::string& setting : arguments.scene.settings) {
    options.push_back(parse_sweep_option(setting));
  }
  if (!arguments.scene.seed.empty()) {
    options.push_back(parse_sweep_seeds(arguments.scene.seed));
  }
  return options;
}

/// All combinations, read before anything is packed, so that a wrong value is said at once.
std::vector<Trial> trials_of(const SweepArguments& arguments, fs::path& folder) {
  const std::vector<std::vector<std::string>> all = combinations(options_of(arguments));
  if (all.size() > most_trials) {
    throw Error(fmt::format("a sweep of {} combinations is too long", all.size()),
                fmt::format("try {} at most", most_trials));
  }
  std::vector<Trial> trials;
  for (const std::vector<std::string>& settings : all) {
    SceneArguments one;
    one.scene = arguments.scene.scene;
    one.settings = settings;
    Trial trial{settings, read_scene_with(one), {}, {}, {}};
    if (folder.empty()) {
      folder = fs::path("out") / (trial.scene.name + "-sweep");
    }
    trial.folder = folder / fmt::format("{:03}", trials.size() + 1);
    trials.push_back(std::move(trial));
  }
  return trials;
}

void write_preview(const fs::path& folder, const Shot& shot, const fs::path& path, Status& status) {
  const FinishedFolder finished = read_finished_folder(folder, status);
  const Composition composition = composition_of(finished);
  const Preview preview(composition, texture_reader(status));
  write_picture(path, encoded(preview.picture(preview_shot(shot))));
}

void pack_trial(Trial& trial, const SweepArguments& arguments, Terminal& terminal) {
  SceneArguments one;
  one.settings = trial.settings;
  try {
    trial.report = pack_scene(trial.scene, command_text(one, trial.scene), trial.folder, terminal);
  } catch (const Error& error) {
    if (error.blame() != Error::Blame::input) {
      throw;
    }
    trial.problem = error.what();
    terminal.note(trial.problem);
    return;
  }
  Shot shot = still_shot(trial.scene, arguments.view);
  shot.width = arguments.size[0];
  shot.height = arguments.size[1];
  write_preview(trial.folder, shot, trial.picture(), terminal);
}

double packing_seconds(const Report& report) {
  return report.seconds.prepare + report.seconds.place + report.seconds.update;
}

/// "threshold 0.03 · seed 2" over "1,204 elements · 14.4 % · 3.1 s".
std::string caption(const Trial& trial) {
  std::string text;
  for (const std::string& setting : trial.settings) {
    const std::size_t equals = setting.find('=');
    const std::string key = setting.substr(0, equals);
    text +=
        fmt::format("{}{} {}", text.empty() ? "" : " · ",
                    key.substr(key.starts_with("packing.") ? 8 : 0), setting.substr(equals + 1));
  }
  const Report& report = *trial.report;
  return fmt::format("{}\n{} elements · {:.2f} % filled · {:.2g} s", text,
                     grouped(report.instances), 100.0 * report.fill, packing_seconds(report));
}

std::string json_of(const Trial& trial) {
  std::string settings;
  for (const std::string& setting : trial.settings) {
    const std::size_t equals = setting.find('=');
    settings +=
        fmt::format("{}{}: {}", settings.empty() ? "" : ", ", json_text(setting.substr(0, equals)),
                    json_text(setting.substr(equals + 1)));
  }
  std::string text = fmt::format("{{\"folder\": {}, \"settings\": {{{}}}, ",
                                 json_text(trial.folder.generic_string()), settings);
  if (!trial.report) {
    return text + "\"problem\": " + json_text(trial.problem) + "}";
  }
  const Report& report = *trial.report;
  return text + fmt::format(
                    "\"picture\": {}, \"instances\": {}, \"fill\": {}, "
                    "\"largest_hole\": {}, \"seconds\": {}}}",
                    json_text(trial.picture().generic_string()), report.instances,
                    number_text(report.fill), number_text(report.largest_hole),
                    number_text(packing_seconds(report)));
}

std::string json_of(const std::vector<Trial>& trials, const fs::path& sheet) {
  std::string rows;
  for (const Trial& trial : trials) {
    rows += (rows.empty() ? "\n  " : ",\n  ") + json_of(trial);
  }
  return fmt::format("{{\"sheet\": {}, \"trials\": [{}\n]}}\n", json_text(sheet.generic_string()),
                     rows);
}

/// Throws Error where nothing could be packed.
void write_sheet(const std::vector<Trial>& trials, const SweepArguments& arguments,
                 const fs::path& sheet) {
  std::vector<SheetPicture> pictures;
  for (const Trial& trial : trials) {
    if (trial.report) {
      pictures.push_back({trial.picture(), caption(trial)});
    }
  }
  if (pictures.empty()) {
    throw Error("none of the combinations can be packed", "the last: " + trials.back().problem);
  }
  SheetLayout layout;
  layout.columns = arguments.columns;
  layout.cell_size = std::max(arguments.size[0], arguments.size[1]);
  layout.title = trials.front().scene.name + " · sweep";
  write_contact_sheet(pictures, layout, sheet);
}

}  // namespace

int run_sweep(const SweepArguments& arguments, const CommonArguments& common, Terminal& terminal) {
  fs::path folder = arguments.scene.folder;
  std::vector<Trial> trials = trials_of(arguments, folder);
  const FolderLock lock(folder, FolderLock::Kind::alone);
  parse_view(arguments.view);
  for (std::size_t i = 0; i < trials.size(); ++i) {
    terminal.note(
        fmt::format("{} of {}: {}", i + 1, trials.size(), fmt::join(trials[i].settings, " ")));
    pack_trial(trials[i], arguments, terminal);
  }
  const fs::path sheet = folder / "sweep.png";
  write_sheet(trials, arguments, sheet);
  const std::string json = json_of(trials, sheet);
  write_file(folder / "sweep.json", json);
  if (common.output == CommonArguments::Output::json) {
    std::fputs(json.c_str(), stdout);
  } else {
    fmt::print("{}\n{}\n", (folder / "sweep.json").string(), sheet.string());
  }
  const bool is_whole = std::ranges::all_of(trials, [](const Trial& t) { return bool(t.report); });
  return is_whole ? 0 : answer_no;
}

int run_preview(const PreviewArguments& arguments, Terminal& terminal) {
  const fs::path folder = folder_of(arguments, terminal);
  const FinishedFolder finished = read_finished_folder(folder, terminal);
  const Scene& scene = finished.sculpture.options;
  const std::vector<std::string>& views =
      arguments.views.empty() ? scene.render.stills : arguments.views;
  if (!arguments.output.empty() && views.size() > 1) {
    throw Error(fmt::format("-o names one picture and there are {} views", views.size()),
                "choose one with --view");
  }
  // Meanwhile, for the pictures to come.
  const std::future<void> loading = std::async(std::launch::async, [] { imaging(); });
  const Composition composition = composition_of(finished);
  const Stage stage(terminal, "previewing");
  const Preview preview(composition, texture_reader(terminal));
  for (std::size_t i = 0; i < views.size(); ++i) {
    terminal.update(static_cast<double>(i) / static_cast<double>(views.size()), views[i]);
    if (terminal.stop_requested()) {
      throw Interrupted();
    }
    Shot shot = still_shot(scene, views[i]);
    shot.width = arguments.size[0];
    shot.height = arguments.size[1];
    const fs::path path = arguments.output.empty()
                              ? folder / "previews" / (file_stem(shot.view) + ".png")
                              : arguments.output;
    write_picture(path, encoded(preview.picture(preview_shot(shot))));
    fmt::print("{}\n", path.string());
  }
  return 0;
}

}  // namespace collage
