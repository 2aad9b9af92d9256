#include <fmt/format.h>

#include "base/error.h"
#include "base/stage.h"
#include "cli/commands.h"
#include "cli/finished_folder.h"
#include "cli/pack_scene.h"
#include "cli/preview_picture.h"
#include "cli/render_outputs.h"
#include "cli/scene_arguments.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

/// The folder named, or that of the scene named, packed now.
fs::path folder_of(const PreviewArguments& arguments, Terminal& terminal) {
  if (fs::exists(fs::path(arguments.scene.scene) / "sculpture.json")) {
    return arguments.scene.scene;
  }
  const Scene scene = read_scene_with(arguments.scene);
  const fs::path folder = output_folder(arguments.scene, scene);
  pack_scene(scene, command_text(arguments.scene, scene), folder, terminal);
  return folder;
}

}  // namespace

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
