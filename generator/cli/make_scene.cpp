#include "cli/make_scene.h"

#include "base/file.h"
#include "base/stopwatch.h"
#include "cli/outline.h"
#include "cli/render_outputs.h"
#include "cli/sculpture_page.h"

namespace collage {

FolderAudit audit_and_note(const std::filesystem::path& folder, const FinishedFolder& finished,
                           Status& status, Measuring measuring) {
  FolderAudit result = audit_folder(folder, finished, status, measuring);
  write_file(folder / "audit.json", audit_json(result));
  if (result.measures.silhouette_iou) {
    write_outline(outline_path(folder), result.measures.silhouette_iou->worst_picture);
  }
  return result;
}

MadeScene make_scene(const Scene& scene, const std::string& command,
                     const std::filesystem::path& folder, const RenderTools& tools,
                     const PackingEnd& end) {
  MadeScene made;
  made.report = pack_scene(scene, command, folder, tools.status, end);
  const FinishedFolder finished = read_finished_folder(folder, tools.status);
  made.audit = audit_and_note(folder, finished, tools.status);
  if (made.audit.passed()) {
    const Stopwatch rendering;
    made.pictures = render_outputs(tools, folder, scene);
    made.report.seconds.render = rendering.seconds();
    write_report(folder / "report.json", made.report);
  }
  write_sculpture_page(folder, finished, made.report, made.audit);
  return made;
}

}  // namespace collage
