#include "cli/gallery.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "cli/data_folder.h"
#include "cli/pack_scene.h"
#include "cli/thesis_tables.h"
#include "cli/version.h"
#include "render/contact_sheet.h"
#include "render/report_page.h"
#include "scene/scene_file.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

/// The first still and nothing else.
Scene for_gallery(const fs::path& scene_folder, const std::string& quality) {
  Scene scene = read_scene(scene_folder / "scene.toml", mesh_libraries());
  scene.render.stills.resize(1);
  scene.render.exr = false;
  scene.turntable.frames = 0;
  scene.contact_sheet.stages.clear();
  if (!quality.empty()) {
    scene.render.quality = quality;
  }
  return scene;
}

void require_passed(const FolderAudit& audit, const fs::path& folder) {
  if (!audit.passed()) {
    throw Error({folder}, "the audit failed", "see " + (folder / "audit.json").string());
  }
}

std::optional<Report> pack_as_in_thesis(const fs::path& scene_folder, const fs::path& folder,
                                        Status& status) {
  const fs::path file = scene_folder / "thesis.toml";
  if (!fs::exists(file)) {
    return std::nullopt;
  }
  const Report report = pack_scene(read_scene(file, mesh_libraries()),
                                   "collage pack " + file.string(), folder, status);
  require_passed(audit_and_note(folder, read_finished_folder(folder, status), status), folder);
  return report;
}

std::string percent(double share) { return fmt::format("{:.2f}", 100.0 * share); }

/// Seconds to place all elements and to update the clearance after each: the thesis's assembly.
double assembly_seconds(const Report& report) {
  return report.seconds.place + report.seconds.update;
}

std::string seconds_text(double seconds) { return fmt::format("{:.2f}", seconds); }

std::string voxels_text(const auto& voxels) {
  return fmt::format("{}×{}×{}", voxels[0], voxels[1], voxels[2]);
}

/// "208, 288" or "108–248".
std::string faces_text(const Report& report) {
  std::vector<std::uint64_t> faces;
  for (const Report::Element& element : report.elements) {
    faces.push_back(element.faces);
  }
  std::ranges::sort(faces);
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  if (faces.size() > 3) {
    return fmt::format("{}–{}", faces.front(), faces.back());
  }
  return fmt::format("{}", fmt::join(faces, ", "));
}

const GalleryPiece* find_piece(const std::vector<GalleryPiece>& pieces, std::string_view scene) {
  const auto found = std::ranges::find(pieces, scene, &GalleryPiece::scene);
  return found == pieces.end() ? nullptr : &*found;
}

/// One line for each sculpture of the thesis that is among the pieces: ours with the thesis's
/// settings, where the scene has them, else as it is.
PageTable thesis_table(const std::vector<GalleryPiece>& pieces) {
  using Kind = PageColumn::Kind;
  PageTable table;
  table.caption = "Muhm 2011, Tables I and II, beside ours";
  table.columns = {{"sculpture", Kind::text},
                   {"voxels, thesis", Kind::text},
                   {"ours", Kind::text},
                   {"elements, thesis"},
                   {"ours"},
                   {"faces, thesis"},
                   {"ours"},
                   {"seconds, thesis"},
                   {"ours"},
                   {"times faster"},
                   {"filled %, thesis"},
                   {"ours"},
                   {"by spheres"},
                   {"of a sphere"}};
  for (const ThesisSculpture& thesis : thesis_sculptures()) {
    const GalleryPiece* piece = find_piece(pieces, thesis.scene);
    if (piece == nullptr) {
      continue;
    }
    const Report& ours = piece->as_in_thesis.value_or(piece->made.report);
    const double seconds = assembly_seconds(ours);
    const double thesis_seconds = 60.0 * thesis.minutes.value_or(0.0);
    table.rows.push_back(
        {{std::string(thesis.scene), voxels_text(thesis.voxels), voxels_text(ours.voxels),
          thesis.elements ? grouped(static_cast<std::uint64_t>(*thesis.elements)) : "–",
          grouped(ours.instances), std::string(thesis.faces), faces_text(ours),
          thesis.minutes ? fmt::format("{:.0f}", thesis_seconds) : "–", seconds_text(seconds),
          thesis.minutes ? grouped(static_cast<std::uint64_t>(thesis_seconds / seconds)) : "–",
          fmt::format("{:.2f}", thesis.fill_percent), percent(ours.fill_by_voxels),
          percent(ours.fill_by_spheres), percent(ours.fill / ours.fill_by_spheres)},
         ""});
  }
  return table;
}

/// Every scene as it is in the gallery.
PageTable gallery_table(const std::vector<GalleryPiece>& pieces) {
  using Kind = PageColumn::Kind;
  PageTable table;
  table.caption = "The gallery's scenes";
  table.columns = {{"scene", Kind::text}, {"voxels", Kind::text}, {"elements"},
                   {"faces in all"},      {"assembly, s"},        {"filled %"},
                   {"outline, mean IoU"}, {"floating %"}};
  for (const GalleryPiece& piece : pieces) {
    const Report& report = piece.made.report;
    std::uint64_t faces = 0;
    for (const Report::Element& element : report.elements) {
      faces += element.faces * element.instances;
    }
    const Measures& measures = piece.made.audit.measures;
    table.rows.push_back(
        {{piece.scene, voxels_text(report.voxels), grouped(report.instances), grouped(faces),
          seconds_text(assembly_seconds(report)), percent(report.fill),
          measures.silhouette_iou ? fmt::format("{:.3f}", measures.silhouette_iou->mean) : "–",
          measures.contacts ? percent(measures.contacts->floating_share) : "–"},
         ""});
  }
  return table;
}

std::string markdown_table(const PageTable& table) {
  std::string text = "|";
  std::string rule = "|";
  for (const PageColumn& column : table.columns) {
    text += " " + column.header + " |";
    rule += column.kind == PageColumn::Kind::text ? "---|" : "---:|";
  }
  text += "\n" + rule + "\n";
  for (const PageRow& row : table.rows) {
    text += "|";
    for (const std::string& cell : row.cells) {
      text += " " + cell + " |";
    }
    text += "\n";
  }
  return text;
}

constexpr const char* thesis_note =
    "The thesis's seconds are its assembly times on a 2.4 GHz Core 2 Duo; ours are those of "
    "placing and updating on this machine. Cutoffs are such that ours have as many elements as "
    "the thesis's. Filled is by voxels, as in the thesis. It is the product of the last two "
    "columns: what the smallest spheres round the elements take of the target (they reach into "
    "each other, since a hollow of one element is free for others), and what an element takes of "
    "its sphere, which is a matter of the model alone. Of spheres, the one element that is the "
    "same in both, ours and the thesis's are filled alike. Where ours is filled less, the last "
    "column tells whether the model is thin, and the one before whether the spheres take less, as "
    "they do in a target that is only a few cutoffs thick.";

std::string gallery_markdown(const std::vector<GalleryPiece>& pieces) {
  return "# Gallery\n\nMade by `collage gallery`, collage " + std::string(version) + ".\n\n" +
         markdown_table(gallery_table(pieces)) + "\n## Beside the thesis\n\n" + thesis_note +
         "\n\n" + markdown_table(thesis_table(pieces));
}

PageCard card_of(const GalleryPiece& piece) {
  const Report& report = piece.made.report;
  PageCard card;
  card.title = piece.scene;
  card.link = piece.scene + "/report.html";
  card.picture = {piece.made.pictures.front(), "The sculpture " + piece.scene, ""};
  card.numbers = {{grouped(report.instances), "copies"}, {percent(report.fill) + " %", "filled"}};
  return card;
}

ReportPage gallery_page(const std::vector<GalleryPiece>& pieces) {
  ReportPage page;
  page.title = "Gallery";
  page.lede = fmt::format(
      "{} shapes, filled with copies of other shapes that never overlap, never "
      "stick out and are never deformed.",
      pieces.size());
  PageSection cards;
  for (const GalleryPiece& piece : pieces) {
    cards.cards.push_back(card_of(piece));
  }
  PageSection figures;
  figures.heading = "In figures";
  figures.tables = {gallery_table(pieces)};
  PageSection thesis;
  thesis.heading = "Beside the thesis";
  thesis.paragraphs = {thesis_note};
  thesis.tables = {thesis_table(pieces)};
  page.sections = {cards, figures, thesis};
  page.footer = std::string("collage ") + version;
  return page;
}

}  // namespace

std::vector<GalleryPiece> make_gallery(const std::vector<fs::path>& scene_folders,
                                       const std::string& quality, const fs::path& folder,
                                       const RenderTools& tools) {
  std::vector<GalleryPiece> pieces;
  for (const fs::path& scene_folder : scene_folders) {
    const std::string name = scene_folder.filename().string();
    const Scene scene = for_gallery(scene_folder, quality);
    GalleryPiece piece{name, make_scene(scene, "collage gallery " + name, folder / name, tools),
                       pack_as_in_thesis(scene_folder, folder / "thesis" / name, tools.status)};
    require_passed(piece.made.audit, folder / name);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

std::vector<fs::path> write_gallery(const std::vector<GalleryPiece>& pieces,
                                    const fs::path& folder) {
  std::vector<SheetPicture> pictures;
  pictures.reserve(pieces.size());
  for (const GalleryPiece& piece : pieces) {
    pictures.push_back({piece.made.pictures.front(), piece.scene});
  }
  SheetLayout layout;
  layout.columns = 4;
  layout.cell_size = 480;
  std::vector<fs::path> paths{folder / "gallery.html", folder / "gallery.png",
                              folder / "gallery.md"};
  write_file(paths[0], report_html(gallery_page(pieces)));
  write_contact_sheet(pictures, layout, paths[1]);
  write_file(paths[2], gallery_markdown(pieces));
  return paths;
}

}  // namespace collage
