#include <cstdio>
#include <thread>

#include <fmt/format.h>

#include "base/error.h"
#include "base/file.h"
#include "base/folder_lock.h"
#include "cli/audit_folder.h"
#include "cli/commands.h"
#include "cli/draft_outputs.h"
#include "cli/finished_folder.h"
#include "cli/gallery.h"
#include "cli/make_scene.h"
#include "cli/offenders.h"
#include "cli/pack_scene.h"
#include "cli/render_outputs.h"
#include "cli/scene_arguments.h"
#include "cli/traced_shadows.h"
#include "scene/set_option.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

void print_report(const CommonArguments& common, const fs::path& folder, const Report& report) {
  const std::string text = common.output == CommonArguments::Output::json
                               ? read_file(folder / "report.json")
                               : report_text(report);
  std::fputs(text.c_str(), stdout);
}

void print_paths(const CommonArguments& common, const std::vector<fs::path>& paths) {
  if (common.output == CommonArguments::Output::text) {
    for (const fs::path& path : paths) {
      fmt::print("{}\n", path.string());
    }
  }
}

/// POV-Ray and what else rendering takes, set up once for a command.
struct Renderer {
  SystemRunner runner;
  Povray povray;
  TracedShadows shadows;
  RenderTools tools;

  Renderer(const CommonArguments& common, Terminal& terminal)
      : povray(find_povray(runner, terminal)),
        shadows(terminal),
        tools{runner, povray, thread_count(common), terminal,
              [this](const fs::path& folder, const Shot& shot) {
                return shadows.declaration(folder, shot);
              }} {}
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;
};

PackingEnd end_of(const SceneArguments& arguments) {
  return {arguments.time_limit_seconds, PackingEnd::OnInterrupt::finish};
}

int exit_code(const Report& report) { return report.stopped == ended_by_user ? interrupted : 0; }

void note_incomplete(const fs::path& folder, const Sculpture& sculpture, Terminal& terminal) {
  if (sculpture.stopped) {
    terminal.note(folder.string() + " is not complete: packing was ended early, by " +
                  *sculpture.stopped);
  }
}

/// The options of a finished folder, with what the command line says about pictures.
Scene finished_scene(const PictureArguments& arguments, Terminal& terminal) {
  const Sculpture sculpture = read_finished_sculpture(arguments.folder);
  note_incomplete(arguments.folder, sculpture, terminal);
  Scene scene = sculpture.options;
  for (const std::string& setting : arguments.settings) {
    set_option(scene, setting);
  }
  if (!arguments.views.empty()) {
    scene.render.stills = arguments.views;
  }
  return scene;
}

void require_element(const PictureArguments& arguments, const Scene& scene) {
  const std::size_t count = scene.elements.size();
  if (arguments.element && static_cast<std::size_t>(*arguments.element) >= count) {
    throw Error({arguments.folder}, fmt::format("has no element {}", *arguments.element),
                fmt::format("choose one of its {}, counted from 0", count));
  }
}

/// The format that the name of a picture asks for.
PictureFormat format_of(const fs::path& picture) {
  for (const PictureFormat format : {PictureFormat::png, PictureFormat::exr}) {
    if (picture.extension() == extension(format)) {
      return format;
    }
  }
  throw Error({picture}, "is not the name of a picture that can be written",
              "let it end in .png or .exr");
}

void require_frames(const PictureArguments& arguments, const Scene& scene) {
  if (scene.turntable.frames == 0) {
    throw Error({arguments.folder}, "its scene asks for no turntable",
                "say how many frames: --set turntable.frames=36");
  }
}

/// What `make` does where previews are all that is wanted.
int make_draft(const SceneArguments& arguments, const CommonArguments& common, Terminal& terminal) {
  const Scene scene = read_scene_with(arguments);
  const fs::path folder = output_folder(arguments, scene);
  const FolderLock lock(folder, FolderLock::Kind::alone);
  const Report report =
      pack_scene(scene, command_text(arguments, scene), folder, terminal, end_of(arguments));
  const FinishedFolder finished = read_finished_folder(folder, terminal);
  const FolderAudit audit = audit_and_note(folder, finished, terminal);
  if (!audit.passed()) {
    std::fputs(audit_text(audit).c_str(), stdout);
    return answer_no;
  }
  SystemRunner runner;
  const std::vector<fs::path> paths = draft_outputs(folder, finished, scene, runner, terminal);
  print_report(common, folder, report);
  print_paths(common, paths);
  return exit_code(report);
}

}  // namespace

int thread_count(const CommonArguments& common) {
  const auto machine = static_cast<int>(std::thread::hardware_concurrency());
  return common.threads > 0 ? common.threads : std::max(1, machine);
}

int run_pack(const SceneArguments& arguments, const CommonArguments& common, Terminal& terminal) {
  const Scene scene = read_scene_with(arguments);
  const fs::path folder = output_folder(arguments, scene);
  const FolderLock lock(folder, FolderLock::Kind::alone);
  const Report report =
      pack_scene(scene, command_text(arguments, scene), folder, terminal, end_of(arguments));
  print_report(common, folder, report);
  print_paths(common, {folder / "scene.pov", folder / "sculpture.json"});
  return exit_code(report);
}

int run_audit(const AuditArguments& arguments, const CommonArguments& common, Terminal& terminal) {
  const FinishedFolder finished = read_finished_folder(arguments.folder, terminal);
  note_incomplete(arguments.folder, finished.sculpture, terminal);
  const FolderAudit result =
      audit_and_note(arguments.folder, finished, terminal, arguments.measuring);
  if (!arguments.offenders.empty()) {
    write_offenders(arguments.folder, finished, result.audit, arguments.offenders, terminal);
  }
  const std::string text =
      common.output == CommonArguments::Output::json ? audit_json(result) : audit_text(result);
  std::fputs(text.c_str(), stdout);
  return result.passed() ? 0 : answer_no;
}

int run_make(const SceneArguments& arguments, const CommonArguments& common, Terminal& terminal) {
  if (arguments.pictures == Pictures::preview) {
    return make_draft(arguments, common, terminal);
  }
  const Scene scene = read_scene_with(arguments);
  const Renderer renderer(common, terminal);  // a missing POV-Ray is said before the work
  const fs::path folder = output_folder(arguments, scene);
  const FolderLock lock(folder, FolderLock::Kind::alone);
  const MadeScene made =
      make_scene(scene, command_text(arguments, scene), folder, renderer.tools, end_of(arguments));
  if (!made.audit.passed()) {
    std::fputs(audit_text(made.audit).c_str(), stdout);
    return answer_no;
  }
  print_report(common, folder, made.report);
  print_paths(common, made.pictures);
  print_paths(common, {folder / "report.html"});
  return exit_code(made.report);
}

int run_gallery(const GalleryArguments& arguments, const CommonArguments& common,
                Terminal& terminal) {
  std::vector<fs::path> folders;
  for (const std::string& name : arguments.scenes) {
    folders.push_back(find_scene(name));
  }
  const Renderer renderer(common, terminal);
  const FolderLock lock(arguments.folder, FolderLock::Kind::alone);
  const auto pieces = make_gallery(folders.empty() ? scene_folders() : folders, arguments.quality,
                                   arguments.folder, renderer.tools);
  print_paths(common, write_gallery(pieces, arguments.folder));
  return 0;
}

int run_still(const PictureArguments& arguments, const CommonArguments& common,
              Terminal& terminal) {
  const FolderLock lock(arguments.folder, FolderLock::Kind::shared);
  const Scene scene = finished_scene(arguments, terminal);
  require_element(arguments, scene);
  PictureFormat format = scene.render.exr ? PictureFormat::exr : PictureFormat::png;
  if (!arguments.output.empty()) {
    format = format_of(arguments.output);
  }
  const Renderer renderer(common, terminal);
  if (!arguments.output.empty() && scene.render.stills.size() > 1) {
    throw Error("-o names one picture and there are " + std::to_string(scene.render.stills.size()) +
                    " views",
                "choose one with --view");
  }
  std::vector<fs::path> paths;
  for (const std::string& view : scene.render.stills) {
    Shot shot = still_shot(scene, view);
    shot.stage = arguments.stage.value_or(1.0);
    shot.only_element = arguments.element;
    shot.format = format;
    paths.push_back(arguments.output.empty() ? still_path(arguments.folder, shot)
                                             : arguments.output);
    const PictureJob job{shot, paths.back()};
    render_pictures(renderer.tools, arguments.folder, std::span(&job, 1),
                    "still " + shot.view.name);
  }
  print_paths(common, paths);
  return 0;
}

int run_turntable(const PictureArguments& arguments, const CommonArguments& common,
                  Terminal& terminal) {
  const FolderLock lock(arguments.folder, FolderLock::Kind::shared);
  const Scene scene = finished_scene(arguments, terminal);
  require_frames(arguments, scene);
  const Renderer renderer(common, terminal);
  render_turntable(renderer.tools, arguments.folder, turntable_of(scene));
  std::vector<fs::path> paths = films(arguments.folder);
  paths.push_back(write_turntable_sheet(arguments.folder, scene));
  print_paths(common, paths);
  return 0;
}

int run_render(const PictureArguments& arguments, const CommonArguments& common,
               Terminal& terminal) {
  const FolderLock lock(arguments.folder, FolderLock::Kind::shared);
  const Scene scene = finished_scene(arguments, terminal);
  if (arguments.pictures == Pictures::preview) {
    SystemRunner runner;
    const FinishedFolder finished = read_finished_folder(arguments.folder, terminal);
    print_paths(common, draft_outputs(arguments.folder, finished, scene, runner, terminal));
    return 0;
  }
  const Renderer renderer(common, terminal);
  if (arguments.frames.empty()) {
    print_paths(common, render_outputs(renderer.tools, arguments.folder, scene));
    return 0;
  }
  require_frames(arguments, scene);
  const FrameRange range = parse_frame_range(arguments.frames, scene.turntable.frames);
  render_turntable_frames(renderer.tools, arguments.folder, turntable_of(scene), range);
  return 0;
}

}  // namespace collage
