#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "audit/audit.h"
#include "audit/silhouette.h"
#include "bench/bar.h"
#include "cli/data_folder.h"
#include "cli/finished_folder.h"
#include "cli/pack_scene.h"
#include "fitting/pack_by_shape.h"
#include "geometry/mesh_file.h"
#include "geometry/models.h"
#include "scene/scene_file.h"
#include "support/folder.h"
#include "support/meshes.h"

namespace collage::bench {
namespace {

namespace fs = std::filesystem;

/// The bars are set in seconds of a machine with so many cores, all at work.
constexpr double cores = 2.0;

Scene scene_of(const fs::path& target, const std::vector<fs::path>& elements) {
  Scene scene;
  scene.name = "bench";
  scene.target.mesh = target;
  for (const fs::path& mesh : elements) {
    scene.elements.emplace_back().mesh = mesh;
  }
  scene.target.resolution = 128;
  scene.packing.threshold = 0.02;
  scene.packing.scaling = Scaling::to_hole;
  return scene;
}

fs::path own_mesh(const std::string& name) {
  return fs::path(COLLAGE_PROJECT_FOLDER) / "scenes" / name;
}

fs::path others_mesh(const std::string& name) { return fs::path(field_folder()) / name; }

/// A scene packed, read again, and judged.
class Filling {
 public:
  Filling(Scene scene, Fit fit) {
    scene.packing.fit = fit;
    const test::Folder folder;
    Status status;
    const double before = processor_seconds();
    const Report report = pack_scene(scene, "bench", folder.path(), status);
    seconds_ = (processor_seconds() - before) / cores;
    percent_ = 100.0 * report.fill;
    finished_ = read_finished_folder(folder.path(), status);
    for (const Mesh& mesh : finished_.elements) {
      elements_.push_back(&mesh);
    }
    const AuditInput input{&*finished_.target, elements_,
                           std::vector<std::vector<double>>(elements_.size()), instances()};
    sound_ = audit(input, status).passed();
  }
  Filling(const Filling&) = delete;
  Filling& operator=(const Filling&) = delete;

  /// Until the files are written.
  [[nodiscard]] double seconds() const { return seconds_; }
  [[nodiscard]] double percent() const { return percent_; }
  [[nodiscard]] bool sound() const { return sound_; }
  [[nodiscard]] std::span<const Instance> instances() const {
    return finished_.sculpture.instances;
  }
  [[nodiscard]] std::size_t count() const { return instances().size(); }
  [[nodiscard]] std::size_t count_of(std::uint32_t element) const {
    return static_cast<std::size_t>(std::ranges::count(instances(), element, &Instance::element));
  }
  [[nodiscard]] Silhouette silhouette() const {
    Status status;
    return collage::silhouette(*finished_.target, InstanceIndex(elements_, instances()), {},
                               status);
  }

 private:
  double seconds_ = 0.0;
  double percent_ = 0.0;
  bool sound_ = false;
  FinishedFolder finished_;
  std::vector<const Mesh*> elements_;
};

Bar fill_bar(const std::string& name, const Filling& filling, double baseline, double percent) {
  return {fmt::format("{}, {} by shape: by spheres", name, filling.count()),
          filling.percent(),
          "%",
          baseline,
          filling.percent() / baseline,
          Bar::Side::at_least,
          percent,
          Bar::Held::figure,
          filling.sound()};
}

Bar time_bar(const std::string& name, const Filling& filling, double allowed) {
  return {fmt::format("{} by shape: the time allowed", name),
          filling.seconds(),
          "CPU s, halved",
          allowed,
          filling.seconds() / allowed,
          Bar::Side::at_most,
          1.0};
}

std::vector<Bar> fill_and_time(const std::string& name, const Scene& scene, double percent,
                               double seconds) {
  const Filling by_spheres(scene, Fit::sphere);
  const Filling by_shape(scene, Fit::shape);
  return {fill_bar(name, by_shape, by_spheres.percent(), percent),
          time_bar(name, by_shape, seconds)};
}

std::vector<Bar> teapot() {
  return fill_and_time("teapot of teacups",
                       scene_of(own_mesh("teapot/teapot.obj"), {own_mesh("teapot/teacup.obj")}),
                       35.0, 60.0);
}

/// On a finer lattice than others: what is to be filled is thin.
std::vector<Bar> chair() {
  Scene scene = scene_of(own_mesh("chair/chair-target.obj"), {own_mesh("chair/chair.obj")});
  scene.target.resolution = 160;
  return fill_and_time("chair of chairs", scene, 15.0, 90.0);
}

std::vector<Bar> rings() {
  const test::Folder folder;
  const fs::path ring = folder.path() / "ring.obj";
  write_obj(ring, test::torus_mesh(1.0, 0.2, 48, 16), "");
  return fill_and_time("bunny of rings", scene_of(others_mesh("targets/bunny.obj"), {ring}), 58.0,
                       45.0);
}

Scene carrots_and_hats() {
  return scene_of(others_mesh("targets/bunny.obj"), {others_mesh("elements/misc/food1_Carrot.obj"),
                                                     others_mesh("elements/misc/top_hat.obj")});
}

std::vector<Bar> alternating() {
  const std::string name = "bunny of carrots and hats in turn";
  Scene scene = carrots_and_hats();
  scene.packing.choose = Choose::alternate;
  const Filling by_spheres(scene, Fit::sphere);
  const Filling by_shape(scene, Fit::shape);
  const double carrots =
      static_cast<double>(by_shape.count_of(0)) / static_cast<double>(by_shape.count());
  return {fill_bar(name, by_shape, by_spheres.percent(), 50.0),
          time_bar(name, by_shape, 60.0),
          {name + ": half are carrots", std::abs(carrots - 0.5), "of all", 0.5,
           std::abs(carrots - 0.5) / 0.5, Bar::Side::at_most, 0.1}};
}

Bar outline_bar(const std::string& name, double iou, double baseline, double bar) {
  return {name, iou, "IoU", baseline, iou / baseline, Bar::Side::at_least, bar, Bar::Held::figure};
}

/// Small elements at the surface, where they draw the outline, and larger ones below it.
std::vector<Bar> larger_in_the_core(const Filling& all_small, double outline) {
  constexpr double lost_at_most = 0.005;
  const std::string name = "bunny, larger ones in the core";
  Scene scene = carrots_and_hats();
  scene.packing.threshold_core = 0.4;
  const Filling filling(scene, Fit::shape);
  const auto count = static_cast<double>(filling.count());
  const auto count_before = static_cast<double>(all_small.count());
  return {{name + ": small ones everywhere", count, "elements", count_before, count / count_before,
           Bar::Side::at_most, 0.5, Bar::Held::ratio, filling.sound()},
          outline_bar(name + ", outline, mean", filling.silhouette().mean, outline,
                      outline - lost_at_most)};
}

std::vector<Bar> any_mix() {
  const std::string name = "bunny of carrots and hats";
  const Filling by_spheres(carrots_and_hats(), Fit::sphere);
  const Filling by_shape(carrots_and_hats(), Fit::shape);
  const Silhouette before = by_spheres.silhouette();
  const Silhouette after = by_shape.silhouette();
  std::vector<Bar> bars{
      fill_bar(name, by_shape, by_spheres.percent(), 62.0), time_bar(name, by_shape, 60.0),
      outline_bar(name + ", outline, mean: by spheres", after.mean, before.mean, 0.95),
      outline_bar(name + ", outline, worst: by spheres", after.worst, before.worst, 0.93)};
  const std::vector<Bar> core = larger_in_the_core(by_shape, after.mean);
  bars.insert(bars.end(), core.begin(), core.end());
  return bars;
}

/// Slender and open things, which their bounding spheres hardly show: what fitting by shape is for.
/// Round ones, such as a basketball, fill more than a third of the rabbit by spheres already.
std::vector<Bar> furniture() {
  constexpr std::array names{"scopia/chair/chair.obj",
                             "scopia/step-ladder-wood/step-ladder-wood.obj",
                             "scopia/bar_chair/bar_chair.obj",
                             "scopia/table4/table4.obj",
                             "scopia/tubular_chair/tubular_chair.obj",
                             "scopia/clothes-rack/clothes-rack.obj",
                             "blendswap-cc-by/foldingChair/foldingChair.obj",
                             "scopia/baby_high_chair/baby_high_chair.obj",
                             "scopia/kids_shelves/kids_shelves.obj",
                             "scopia/kitchen_stool/kitchen_stool.obj"};
  const fs::path folder = mesh_libraries().folder / "sweethome3d-furniture";
  std::vector<fs::path> elements;
  for (const char* name : names) {
    elements.push_back(folder / name);
  }
  const std::string name = "rabbit of ten slender things";
  Scene scene = scene_of(folder / "scopia/rabbit/rabbit.obj", elements);
  scene.packing.choose = Choose::alternate;
  const Filling by_spheres(scene, Fit::sphere);
  const Filling by_shape(scene, Fit::shape);
  Bar filled = fill_bar(name, by_shape, by_spheres.percent(), 3.0);
  filled.held = Bar::Held::ratio;
  return {filled, time_bar(name, by_shape, 120.0)};
}

/// What packing alone takes: carrots of radii from 0.02 to 0.1 in the teapot, and in effect in
/// teapots `fineness` times as large.
class Growth {
 public:
  struct Sample {
    double count;
    double seconds;
  };
  [[nodiscard]] Sample pack(double fineness) const {
    Status status;
    FreeSpace space(target_, static_cast<int>(128 * fineness), status);
    PackingOptions options;
    options.scaling = Scaling::to_hole;
    options.threshold = 0.02 / fineness;
    options.largest = 0.1 / fineness;
    const std::array<ShapeIngredient, 1> ingredients{{{shape_}}};
    const double before = processor_seconds();
    const Packing packing =
        pack_by_shape({target_, &surface_}, space, ingredients, options, status);
    return {static_cast<double>(packing.instances.size()), processor_seconds() - before};
  }

 private:
  Mesh target_mesh_ = make_teapot(10);
  Mesh element_mesh_ = make_carrot();
  MeshTarget target_{target_mesh_};
  CollisionShape surface_{target_mesh_, target_.solid()};
  Element element_{element_mesh_};
  ShapedElement shape_{element_mesh_, element_, measure_shape(element_mesh_, element_)};
};

/// The exponent of time in the number of elements, beside that of n log n.
std::vector<Bar> growth(double coarse, double fine, std::optional<double> seconds_allowed) {
  const Growth growth;
  // The short one twice before and twice after, as machines are now faster and now slower.
  Growth::Sample few = growth.pack(coarse);
  few.seconds += growth.pack(coarse).seconds;
  const Growth::Sample many = growth.pack(fine);
  few.seconds += growth.pack(coarse).seconds + growth.pack(coarse).seconds;
  few.seconds /= 4.0;
  const auto exponent = [&](double small, double large) {
    return std::log(large / small) / std::log(many.count / few.count);
  };
  const double found = exponent(few.seconds, many.seconds);
  const double n_log_n =
      exponent(few.count * std::log(few.count), many.count * std::log(many.count));
  const std::string name = fmt::format("from {} carrots to {}", few.count, many.count);
  std::vector<Bar> bars{{name + ": time by n log n", found, "exponent", n_log_n, found / n_log_n,
                         Bar::Side::at_most, 1.0}};
  if (seconds_allowed) {
    const double seconds = many.seconds / cores;
    bars.push_back({name + ": the time allowed", seconds, "CPU s, halved", *seconds_allowed,
                    seconds / *seconds_allowed, Bar::Side::at_most, 1.0});
  }
  return bars;
}

}  // namespace

std::vector<Group> shape_bars() {
  return {{"shape-teapot", teapot},
          {"shape-chair", chair},
          {"shape-rings", rings, Group::Meshes::field},
          {"shape-alternating", alternating, Group::Meshes::field},
          {"shape-any-mix", any_mix, Group::Meshes::field},
          {"shape-furniture", furniture, Group::Meshes::furniture},
          {"shape-growth", [] { return growth(0.5, 1.0, std::nullopt); }},
          {"shape-growth-20000", [] { return growth(1.0, 1.76, 600.0); }, Group::Meshes::own,
           Group::Named::in_full}};
}

}  // namespace collage::bench
