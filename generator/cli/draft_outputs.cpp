#include "cli/draft_outputs.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "base/error.h"
#include "base/stage.h"
#include "cli/preview_picture.h"
#include "cli/render_outputs.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

std::vector<PictureJob> still_jobs(const fs::path& folder, const Scene& scene) {
  std::vector<PictureJob> jobs;
  for (const std::string& view : scene.render.stills) {
    const Shot shot = still_shot(scene, view);
    jobs.push_back({shot, still_path(folder, shot)});
  }
  return jobs;
}

/// Previews of a composition; those of one stage share what they are made from.
class Drafts {
 public:
  Drafts(const Composition& composition, Status& status)
      : composition_(composition), status_(status) {}

  void make(const std::vector<PictureJob>& jobs, const std::string& noun) {
    const Stage stage(status_, "previewing");
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      status_.update(static_cast<double>(i) / static_cast<double>(jobs.size()),
                     fmt::format("{} {} of {}", noun, i + 1, jobs.size()));
      if (status_.stop_requested()) {
        throw Interrupted();
      }
      const Shot& shot = jobs[i].shot;
      write_picture(jobs[i].output, encoded(preview_of(shot.stage).picture(preview_shot(shot))));
    }
  }

 private:
  const Preview& preview_of(double stage) {
    if (!preview_ || stage != stage_) {
      preview_.emplace(composition_, texture_reader(status_), PreviewShown{stage, std::nullopt});
      stage_ = stage;
    }
    return *preview_;
  }

  const Composition& composition_;
  Status& status_;
  std::optional<Preview> preview_;
  double stage_ = 0.0;
};

}  // namespace

std::vector<fs::path> draft_outputs(const fs::path& folder, const FinishedFolder& finished,
                                    const Scene& scene, CommandRunner& runner, Status& status) {
  const fs::path place = folder / "draft";
  const Composition composition = composition_of(finished);
  Drafts drafts(composition, status);
  std::vector<fs::path> paths;
  const std::vector<PictureJob> stills = still_jobs(place, scene);
  drafts.make(stills, "still");
  std::ranges::transform(stills, std::back_inserter(paths), &PictureJob::output);
  if (!scene.contact_sheet.stages.empty()) {
    drafts.make(stage_jobs(place, scene), "stage");
    paths.push_back(write_stage_sheet(place, scene));
  }
  if (scene.turntable.frames > 0) {
    const Turntable turntable = turntable_of(scene);
    drafts.make(turntable_jobs(place, turntable, {1, turntable.frames}), "frame");
    assemble_turntable(runner, place, turntable, status);
    std::ranges::copy(films(place), std::back_inserter(paths));
    paths.push_back(write_turntable_sheet(place, scene));
  }
  return paths;
}

}  // namespace collage
