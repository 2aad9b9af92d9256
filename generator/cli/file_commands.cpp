#include <algorithm>
#include <cstdio>

#include <fmt/format.h>

#include "base/error.h"
#include "base/text.h"
#include "cli/commands.h"
#include "cli/data_folder.h"
#include "cli/finished_folder.h"
#include "cli/read_mesh.h"
#include "fitting/shape_cache.h"
#include "geometry/mesh_check.h"
#include "geometry/mesh_file.h"
#include "geometry/mesh_repair.h"
#include "geometry/models.h"
#include "packing/target.h"
#include "render/contact_sheet.h"
#include "scene/obj_exporter.h"
#include "scene/options_reference.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

/// Reads the meshes of a finished folder and writes all instances as one OBJ.
void export_sculpture(const fs::path& folder, const fs::path& obj, Terminal& terminal) {
  const FinishedFolder finished = read_finished_folder(folder, terminal);
  export_obj(obj, composition_of(finished), terminal);
}

void export_distances(const fs::path& mesh_path, const fs::path& sdf, int resolution,
                      Terminal& terminal) {
  const Mesh mesh = read_mesh(mesh_path, Repair::full, terminal).mesh;
  const MeshTarget target(mesh);
  write_distance_grid(sdf, sample_distance_grid(target.solid(), target.box(), resolution));
}

const char* word(Verdict verdict) {
  switch (verdict) {
    case Verdict::same:
      return "same";
    case Verdict::within_tolerance:
      return "within tolerance";
    case Verdict::differs:
      break;
  }
  return "differs";
}

std::string comparison_json(const Comparison& comparison) {
  std::string text = fmt::format(R"({{"verdict": "{}")", word(comparison.verdict));
  if (comparison.numbers) {
    const Comparison::Numbers& n = *comparison.numbers;
    text += fmt::format(
        R"(, "mean_error": {}, "max_error": {}, "psnr_decibels": {}, "failing_pixels": {}, "pixels": {})",
        number_text(n.mean_error), number_text(n.max_error),
        n.psnr_decibels ? number_text(*n.psnr_decibels) : "null", n.failing_pixels, n.pixels);
  }
  return text + "}\n";
}

void write_model(const StarterModel& model, const fs::path& path) {
  write_obj(path, model.make(),
            fmt::format("collage model {} -o {}", model.name, path.filename().string()));
  fmt::print("{}\n", path.string());
}

/// As balls of the mesh's own size, in its place.
Mesh covering_of(const Mesh& mesh) {
  constexpr int subdivisions = 2;
  const Element element(mesh);
  const SphereCover cover = cached_shape(mesh, element, cache_folder()).fine;
  const Mesh ball = make_sphere(subdivisions);
  Mesh balls;
  for (const Sphere& sphere : cover.spheres) {
    const auto first = static_cast<std::uint32_t>(balls.positions.size());
    for (const dvec3& position : ball.positions) {
      balls.positions.push_back(
          element.solid().mesh_from_unit(sphere.center + sphere.radius * position));
    }
    for (const uvec3& triangle : ball.triangles) {
      balls.triangles.push_back(triangle + first);
    }
  }
  return balls;
}

void write_covering(const fs::path& obj, const fs::path& path, Terminal& terminal) {
  write_obj(path, covering_of(read_mesh(obj, Repair::full, terminal).mesh), "");
  fmt::print("{}\n", path.string());
}

std::string comparison_text(const Comparison& comparison) {
  std::string text = fmt::format("{}: {}\n", word(comparison.verdict), comparison.reason);
  if (comparison.numbers && comparison.verdict != Verdict::same) {
    const Comparison::Numbers& n = *comparison.numbers;
    text += fmt::format(
        "mean error {:.6f}, maximum {:.6f} at {},{}, PSNR {:.2f} dB, {} of {} pixels fail\n",
        n.mean_error, n.max_error, n.max_x, n.max_y, n.psnr_decibels.value_or(0.0),
        grouped(static_cast<std::uint64_t>(n.failing_pixels)),
        grouped(static_cast<std::uint64_t>(n.pixels)));
  }
  return text;
}

const StarterModel& model_called(const std::string& name) {
  const auto models = starter_models();
  const auto model = std::find_if(models.begin(), models.end(),
                                  [&](const StarterModel& m) { return m.name == name; });
  if (model == models.end()) {
    std::vector<std::string> names;
    std::transform(models.begin(), models.end(), std::back_inserter(names),
                   [](const StarterModel& m) { return std::string(m.name); });
    const std::string guess = did_you_mean(name, names);
    throw Error("there is no model '" + name + "'",
                guess.empty() ? "`collage model` lists those that there are" : guess);
  }
  return *model;
}

}  // namespace

int run_sheet(const SheetArguments& arguments) {
  if (arguments.captions.size() > arguments.pictures.size()) {
    throw Error("there are more captions than pictures", "give one --caption a picture, or fewer");
  }
  std::vector<SheetPicture> pictures;
  for (std::size_t i = 0; i < arguments.pictures.size(); ++i) {
    const fs::path& path = arguments.pictures[i];
    pictures.push_back(
        {path, i < arguments.captions.size() ? arguments.captions[i] : path.stem().string()});
  }
  SheetLayout layout;
  layout.columns = std::min(arguments.columns, static_cast<int>(pictures.size()));
  layout.cell_size = arguments.cell_size;
  layout.title = arguments.title;
  write_contact_sheet(pictures, layout, arguments.output);
  fmt::print("{}\n", arguments.output.string());
  return 0;
}

int run_compare(const CompareArguments& arguments, const CommonArguments& common) {
  const Comparison comparison =
      compare_pictures(arguments.reference, arguments.picture, arguments.thresholds);
  const bool can_be_laid_over = comparison.numbers.has_value();
  if (!arguments.difference.empty() && can_be_laid_over) {
    write_difference(arguments.reference, arguments.picture, arguments.difference,
                     arguments.amplification);
  }
  const std::string text = common.output == CommonArguments::Output::json
                               ? comparison_json(comparison)
                               : comparison_text(comparison);
  std::fputs(text.c_str(), stdout);
  return comparison.verdict == Verdict::differs ? answer_no : 0;
}

int run_export(const ExportArguments& arguments, Terminal& terminal) {
  if (arguments.obj.empty() == arguments.sdf.empty()) {
    throw Error("nothing to export, or two things at once",
                "give a folder and --obj FILE, or a mesh and --sdf FILE");
  }
  if (!arguments.obj.empty()) {
    export_sculpture(arguments.input, arguments.obj, terminal);
  } else {
    export_distances(arguments.input, arguments.sdf, arguments.resolution, terminal);
  }
  fmt::print("{}\n", (arguments.obj.empty() ? arguments.sdf : arguments.obj).string());
  return 0;
}

int run_check(const std::vector<fs::path>& meshes, Terminal& terminal) {
  for (const fs::path& path : meshes) {
    Mesh mesh = read_obj(path, terminal).mesh;
    const std::vector<std::string> repairs = repair(mesh);
    fmt::print("{}: {}\n", path.string(), text_of(check_mesh(mesh)));
    fmt::print("  volume of the solid {:.6g}\n", MeshTarget(mesh).volume());
    for (const std::string& done : repairs) {
      fmt::print("  {}\n", done);
    }
  }
  return 0;
}

int run_model(const ModelArguments& arguments, Terminal& terminal) {
  const bool letters = !arguments.letters.string.empty();
  const fs::path& output = arguments.output;
  if (arguments.all) {
    for (const StarterModel& model : starter_models()) {
      write_model(model, output / fmt::format("{}.obj", model.name));
    }
  } else if (letters) {
    const fs::path path = output.empty() ? fs::path("letters.obj") : output;
    write_obj(path, make_letters(arguments.letters, terminal), "");
    fmt::print("{}\n", path.string());
  } else if (!arguments.covered.empty()) {
    write_covering(arguments.covered, output.empty() ? fs::path("covering.obj") : output, terminal);
  } else if (arguments.name.empty()) {
    for (const StarterModel& model : starter_models()) {
      fmt::print("{:15} {}\n", model.name, model.description);
    }
  } else {
    write_model(model_called(arguments.name),
                output.empty() ? fs::path(arguments.name + ".obj") : output);
  }
  return 0;
}

std::vector<fs::path> scene_folders() {
  std::vector<fs::path> folders;
  for (const auto& entry : fs::directory_iterator(data_folder(data_places()) / "scenes")) {
    if (fs::exists(entry.path() / "scene.toml")) {
      folders.push_back(entry.path());
    }
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

int run_scenes() {
  for (const fs::path& folder : scene_folders()) {
    fmt::print("{}\n", folder.filename().string());
  }
  return 0;
}

int run_options(CommonArguments::Output output) {
  const std::string text =
      output == CommonArguments::Output::text ? options_text() : scene_reference_markdown();
  std::fputs(text.c_str(), stdout);
  return 0;
}

}  // namespace collage
