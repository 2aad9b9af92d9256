#include "cli/pack_scene.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>
#include <tbb/parallel_for.h>

#include "base/error.h"
#include "base/file.h"
#include "base/stage.h"
#include "base/staging.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "cli/data_folder.h"
#include "cli/prepare_packing.h"
#include "cli/read_mesh.h"
#include "cli/stop_signals.h"
#include "cli/version.h"
#include "packing/pack.h"
#include "scene/copy_inputs.h"
#include "scene/povray_writer.h"
#include "scene/sculpture_file.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

/// The mesh of a target or an element, which comes from files or from letters.
template <class Owner>
MeshFile shape(const Owner& wanted, Status& status) {
  return wanted.text.string.empty() ? read_mesh(wanted.mesh, wanted.repair, status)
                                    : MeshFile{make_letters(wanted.text, status), {}};
}

/// All that is read before anything is placed. Ingredients refer to the elements, and elements to
/// nothing: it stays in its place.
struct Workshop {
  Workshop(const Scene& scene, Status& status);
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  std::vector<fs::path> target_files;
  Mesh target_mesh;
  std::unique_ptr<Target> target;
  std::vector<MeshFile> element_files;
  std::vector<std::unique_ptr<Element>> elements;
  std::vector<Ingredient> ingredients;
  std::vector<MeshFile> props;

  [[nodiscard]] PackingInput packing_input() const;

 private:
  void read_target(const Scene::Target& wanted, Status& status);
};

void Workshop::read_target(const Scene::Target& wanted, Status& status) {
  if (wanted.sdf.empty()) {
    MeshFile file = shape(wanted, status);
    target_files = file.files;
    target_mesh = std::move(file.mesh);
    target = std::make_unique<MeshTarget>(target_mesh);
  } else {
    target_files = {wanted.sdf};
    target = std::make_unique<GridTarget>(read_distance_grid(wanted.sdf));
  }
}

Workshop::Workshop(const Scene& scene, Status& status) {
  const std::size_t count = scene.elements.size();
  for (const Scene::Element& wanted : scene.elements) {
    status.update(0.0, wanted.name());
    if (status.stop_requested()) {
      throw Interrupted();
    }
    element_files.push_back(shape(wanted, status));
  }
  read_target(scene.target, status);
  for (const std::string& prop : scene.render.props) {
    props.push_back(read_mesh(prop, Repair::full, status));
  }
  elements.resize(count);
  constexpr std::size_t few = 8;
  const auto bounds = count <= few ? DistanceBounds::Detail::fine : DistanceBounds::Detail::coarse;
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t e) {
    elements[e] = std::make_unique<Element>(element_files[e].mesh, scene.packing.distance,
                                            scene.packing.fit, bounds);
  });
  for (std::size_t e = 0; e < count; ++e) {
    const Scene::Element& wanted = scene.elements[e];
    ingredients.push_back({*elements[e], wanted.scales, wanted.weight, wanted.left, wanted.right});
  }
}

PackingInput Workshop::packing_input() const {
  PackingInput input{*target, target_mesh, ingredients, {}};
  for (const MeshFile& file : element_files) {
    input.meshes.push_back(&file.mesh);
  }
  return input;
}

/// Asks the packing to finish when its time has come or Ctrl-C was pressed.
class EarlyEnd : public Status {
 public:
  EarlyEnd(Status& whole, const PackingEnd& end) : whole_(whole), end_(end) {}

  void begin(std::string_view stage) override { whole_.begin(stage); }
  void update(double fraction, std::string_view detail) override {
    whole_.update(fraction, std::string(detail) + (offer_ ? ", Ctrl-C ends with these" : ""));
  }
  void end() override { whole_.end(); }
  void note(std::string_view line) override { whole_.note(line); }
  [[nodiscard]] bool stop_requested() const override { return whole_.stop_requested(); }
  [[nodiscard]] bool finish_requested() const override {
    return is_interrupted() || (end_.seconds && watch_.seconds() >= *end_.seconds);
  }

  /// Until it is withdrawn, Ctrl-C asks to finish, where that is wanted.
  void offer() {
    if (end_.on_interrupt == PackingEnd::OnInterrupt::finish) {
      offer_.emplace();
    }
  }
  void withdraw() { offer_.reset(); }

  /// For people and for sculpture.json.
  [[nodiscard]] std::string reason() const {
    return is_interrupted() ? std::string(ended_by_user) : "time limit";
  }

 private:
  [[nodiscard]] bool is_interrupted() const {
    return end_.on_interrupt == PackingEnd::OnInterrupt::finish && StopSignals::finish_requested();
  }

  Status& whole_;
  const PackingEnd& end_;
  Stopwatch watch_;
  std::optional<FinishOffer> offer_;
};

/// An empty sculpture is a mistake in the scene; says which.
[[noreturn]] void throw_nothing_fits(const Scene& scene, const Workshop& workshop,
                                     const Packing& packing) {
  const double longest = workshop.target->box().longest_side();
  const std::string hole = fmt::format("{:.4g}", packing.largest_hole / longest);
  if (packing.voxels_inside_target == 0) {
    throw Error({scene.file}, "the target holds no space at this resolution",
                "raise target.resolution, or check the mesh with: collage check");
  }
  if (packing.largest_hole < (scene.packing.threshold + scene.packing.spacing) * longest) {
    throw Error({scene.file}, "the largest hole, of radius " + hole + ", is below the threshold",
                "lower packing.threshold or packing.spacing");
  }
  throw Error({scene.file},
              "no element is small enough for the largest hole, of radius " + hole +
                  " (a fraction of the target's longest side)",
              "list smaller element.scales, or use packing.scaling = \"to-hole\"");
}

/// What a mesh was read from, or the mesh itself where that was made of letters, in the folder.
Sculpture::Input input(const std::vector<fs::path>& files, const Mesh& mesh, const fs::path& folder,
                       const std::string& role, Status& status) {
  return files.empty() ? write_input(mesh, "letters", folder, role)
                       : copy_inputs(files, folder, role, status);
}

Sculpture describe(const Scene& scene, const std::string& command, const Workshop& workshop,
                   const std::vector<Instance>& instances, const fs::path& folder, Status& status) {
  Sculpture sculpture;
  sculpture.version = version;
  sculpture.command = command;
  sculpture.options = scene;
  sculpture.scene_sha256 = sha256(read_file(folder / "scene.pov"));
  sculpture.instances = instances;
  sculpture.target = input(workshop.target_files, workshop.target_mesh, folder, "target", status);
  for (std::size_t e = 0; e < scene.elements.size(); ++e) {
    Sculpture::Element element;
    const MeshFile& file = workshop.element_files[e];
    static_cast<Sculpture::Input&>(element) =
        input(file.files, file.mesh, folder, "element-" + std::to_string(e), status);
    element.name = scene.elements[e].name();
    element.size = workshop.elements[e]->size();
    sculpture.elements.push_back(element);
  }
  for (const MeshFile& prop : workshop.props) {
    const std::string role = "prop-" + std::to_string(sculpture.props.size());
    sculpture.props.push_back(copy_inputs(prop.files, folder, role, status));
  }
  return sculpture;
}

Composition compose(const Scene& scene, const Workshop& workshop,
                    std::span<const Instance> instances) {
  Composition composition;
  composition.name = scene.name;
  composition.made_by = std::string("collage ") + version;
  for (std::size_t e = 0; e < scene.elements.size(); ++e) {
    const Scene::Element& options = scene.elements[e];
    composition.elements.push_back(
        {options.name(), workshop.element_files[e].mesh, options.color, options.finish});
  }
  for (const MeshFile& prop : workshop.props) {
    composition.props.push_back({prop.files.front().stem().string(), prop.mesh});
  }
  composition.instances = instances;
  composition.target = scene.target.sdf.empty() ? &workshop.target_mesh : nullptr;
  composition.target_box = workshop.target->box();
  return composition;
}

void copy_templates(const Scene& scene, const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(data_folder(data_places()) / "templates")) {
    if (entry.path().extension() == ".inc") {
      write_file(folder / entry.path().filename(), read_file(entry.path()));
    }
  }
  const fs::path look(scene.render.look);
  if (look.extension() == ".inc") {
    write_file(folder / look.filename(), read_file(look));
  }
}

/// Of the smallest spheres round the instances.
double sphere_volume(const Workshop& workshop, std::span<const Instance> instances) {
  double volume = 0.0;
  for (const Instance& instance : instances) {
    const double radius = instance.scale * workshop.elements[instance.element]->size();
    volume += 4.0 / 3.0 * glm::pi<double>() * radius * radius * radius;
  }
  return volume;
}

Report summarise(const Scene& scene, const Workshop& workshop, const Packing& packing) {
  Report report;
  report.seed = scene.packing.seed;
  report.instances = packing.instances.size();
  report.fill = fill(*workshop.target, workshop.ingredients, packing.instances);
  report.fill_by_voxels = packing.fill_by_voxels();
  report.fill_by_spheres = sphere_volume(workshop, packing.instances) / workshop.target->volume();
  report.largest_hole = packing.largest_hole / workshop.target->box().longest_side();
  for (int axis = 0; axis < 3; ++axis) {
    report.voxels[static_cast<std::size_t>(axis)] =
        static_cast<std::uint64_t>(packing.voxels[axis]);
  }
  for (std::size_t e = 0; e < scene.elements.size(); ++e) {
    const auto count =
        std::count_if(packing.instances.begin(), packing.instances.end(),
                      [e](const Instance& instance) { return instance.element == e; });
    report.elements.push_back({scene.elements[e].name(), workshop.elements[e]->faces(),
                               static_cast<std::uint64_t>(count)});
  }
  report.seconds.place = packing.place_seconds;
  report.seconds.update = packing.update_seconds;
  return report;
}

}  // namespace

Report pack_scene(const Scene& scene, const std::string& command, const fs::path& folder,
                  Status& status, const PackingEnd& end) {
  EarlyEnd early(status, end);
  { const FileWriter probe(folder / "sculpture.json"); }  // an unwritable folder is said now
  Stopwatch preparing;
  status.begin("preparing");
  const Workshop workshop(scene, status);
  const auto run_packing = prepare_packing(scene, workshop.packing_input(), early);
  status.end();
  const double prepare_seconds = preparing.seconds();

  if (scene.packing.distance == Distance::vertices) {
    status.note("distances are measured to vertices only: instances overlap");
  }
  status.begin("packing");
  early.offer();
  const Packing packing = run_packing(early);
  early.withdraw();
  status.end();
  std::optional<std::string> stopped;
  if (!packing.complete) {
    stopped = early.reason();
    status.note("ended by " + *stopped + " with " + grouped(packing.instances.size()) +
                " instances; going on with these" +
                (*stopped == ended_by_user ? ", until Ctrl-C is pressed again" : ""));
  }
  if (packing.instances.empty()) {
    throw_nothing_fits(scene, workshop, packing);
  }

  Stopwatch writing;
  const Stage stage(status, "writing");
  Staging staging(folder);
  copy_templates(scene, staging.folder());
  write_povray(staging.folder(), compose(scene, workshop, packing.instances),
               fs::path(scene.render.look).stem().string(), status);
  Sculpture sculpture =
      describe(scene, command, workshop, packing.instances, staging.folder(), status);
  sculpture.stopped = stopped;
  write_sculpture(staging.folder() / "sculpture.json", sculpture);
  Report report = summarise(scene, workshop, packing);
  report.stopped = stopped;
  report.seconds.prepare = prepare_seconds;
  report.seconds.write = writing.seconds();
  write_report(staging.folder() / "report.json", report);
  staging.commit();
  return report;
}

}  // namespace collage
