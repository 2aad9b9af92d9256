#include "cli/render_outputs.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "render/contact_sheet.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

std::string percent(double share) { return fmt::format("{:.4g} %", 100.0 * share); }

SheetLayout layout_of(const Scene& scene, const std::array<int, 2>& size) {
  SheetLayout layout;
  layout.columns = scene.contact_sheet.columns;
  layout.cell_size = std::max(size[0], size[1]);
  return layout;
}

}  // namespace

Shot still_shot(const Scene& scene, const std::string& view) {
  Shot shot;
  shot.view = parse_view(view);
  shot.look = fs::path(scene.render.look).stem().string();
  shot.width = scene.render.size[0];
  shot.height = scene.render.size[1];
  shot.quality = parse_quality(scene.render.quality);
  return shot;
}

Turntable turntable_of(const Scene& scene) {
  Turntable turntable;
  turntable.shot = still_shot(scene, "front");
  turntable.shot.view.elevation_degrees = scene.turntable.elevation_degrees;
  turntable.shot.width = scene.turntable.size[0];
  turntable.shot.height = scene.turntable.size[1];
  turntable.shot.quality = parse_quality(scene.turntable.quality);
  turntable.frames = scene.turntable.frames;
  turntable.frames_per_second = scene.turntable.frames_per_second;
  return turntable;
}

fs::path still_path(const fs::path& folder, const Shot& shot) {
  return folder / "stills" / (file_stem(shot.view) + extension(shot.format));
}

std::vector<fs::path> render_stills(const RenderTools& tools, const fs::path& folder,
                                    const Scene& scene) {
  std::vector<fs::path> paths;
  for (const std::string& view : scene.render.stills) {
    Shot shot = still_shot(scene, view);
    for (const PictureFormat format : {PictureFormat::png, PictureFormat::exr}) {
      if (format == PictureFormat::exr && !scene.render.exr) {
        continue;
      }
      shot.format = format;
      paths.push_back(still_path(folder, shot));
      const PictureJob job{shot, paths.back()};
      render_pictures(tools, folder, std::span(&job, 1), "still " + shot.view.name);
    }
  }
  return paths;
}

std::vector<PictureJob> stage_jobs(const fs::path& folder, const Scene& scene) {
  std::vector<PictureJob> jobs;
  for (const double share : scene.contact_sheet.stages) {
    Shot shot = still_shot(scene, "three-quarter");
    shot.width = scene.contact_sheet.size[0];
    shot.height = scene.contact_sheet.size[1];
    shot.quality = parse_quality(scene.contact_sheet.quality);
    shot.stage = share;
    jobs.push_back({shot, folder / "stages" / fmt::format("stage-{}.png", jobs.size() + 1)});
  }
  return jobs;
}

fs::path write_stage_sheet(const fs::path& folder, const Scene& scene) {
  std::vector<SheetPicture> pictures;
  for (const PictureJob& job : stage_jobs(folder, scene)) {
    pictures.push_back({job.output, percent(job.shot.stage)});
  }
  SheetLayout layout = layout_of(scene, scene.contact_sheet.size);
  layout.columns = std::min(layout.columns, static_cast<int>(pictures.size()));
  layout.title = scene.name + " · stages of the assembly";
  fs::path sheet = folder / "sheets" / "stages.png";
  write_contact_sheet(pictures, layout, sheet);
  return sheet;
}

fs::path render_stage_sheet(const RenderTools& tools, const fs::path& folder, const Scene& scene) {
  render_pictures(tools, folder, stage_jobs(folder, scene), "stage");
  return write_stage_sheet(folder, scene);
}

std::vector<fs::path> films(const fs::path& folder) {
  std::vector<fs::path> paths;
  for (const char* film : {"turntable.mp4", "turntable.gif"}) {
    if (fs::exists(folder / "turntable" / film)) {
      paths.push_back(folder / "turntable" / film);
    }
  }
  return paths;
}

fs::path write_turntable_sheet(const fs::path& folder, const Scene& scene) {
  std::vector<SheetPicture> pictures;
  const auto frames = turntable_frames(folder, scene.turntable.frames);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const double degrees = 360.0 * static_cast<double>(k) / static_cast<double>(frames.size());
    pictures.push_back({frames[k], fmt::format("{:.4g}°", degrees)});
  }
  SheetLayout layout = layout_of(scene, {320, 240});
  layout.title = scene.name + " · turntable";
  fs::path sheet = folder / "sheets" / "turntable.png";
  write_contact_sheet(pictures, layout, sheet);
  return sheet;
}

std::vector<fs::path> render_outputs(const RenderTools& tools, const fs::path& folder,
                                     const Scene& scene) {
  std::vector<fs::path> paths = render_stills(tools, folder, scene);
  if (!scene.contact_sheet.stages.empty()) {
    paths.push_back(render_stage_sheet(tools, folder, scene));
  }
  if (scene.turntable.frames > 0) {
    render_turntable(tools, folder, turntable_of(scene));
    std::ranges::copy(films(folder), std::back_inserter(paths));
    paths.push_back(write_turntable_sheet(folder, scene));
  }
  return paths;
}

}  // namespace collage
