#include "fitting/pack_by_shape.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "base/error.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "fitting/kinds.h"
#include "fitting/placed_shapes.h"
#include "fitting/quota.h"
#include "fitting/vacancy_fitter.h"

namespace collage {
namespace {

/// Places opened at a time, whatever the number of threads: of each kind fewer where there are
/// many, since each turn of another kind costs some of them their poses.
constexpr std::size_t batch = 8;
constexpr std::size_t least_batch = 4;
/// A hole is offered to two kinds, or to one of many: tried in vain, it is offered to another in
/// the next sweep.
constexpr std::size_t few_kinds = 2;
/// Where links are sought, one of this many times less size is as good.
constexpr double link_preference = 2.0;
constexpr std::uint64_t choice_stream = 0x63686f696365ULL;

class ShapePacker {
 public:
  ShapePacker(const ShapeTarget& target, FreeSpace& space,
              std::span<const ShapeIngredient> ingredients, const PackingOptions& options);

  Packing run(Status& status);

 private:
  using Id = HoleQueue::Id;

  void add_holes(const std::vector<FreeSpace::Peak>& peaks);
  void add_vacancy(std::uint32_t kind, const FreeSpace::Peak& peak);
  [[nodiscard]] double apart(double clearance) const;
  [[nodiscard]] double least_radius(const Kind& kind, const dvec3& at) const;
  [[nodiscard]] bool is_too_small(const Kind& kind, double clearance, const dvec3& at) const;

  [[nodiscard]] std::optional<std::uint32_t> next_kind();
  [[nodiscard]] std::optional<std::uint32_t> next_element(std::uint32_t kind,
                                                          const Pose& pose) const;
  [[nodiscard]] std::optional<Id> next_vacancy(std::uint32_t kind);
  bool is_as_listed(Vacancy& vacancy) const;
  void open_batch(std::uint32_t kind, const Status& status);
  void open(Vacancy& vacancy, std::uint64_t stream);
  void fill(Id id);
  void add_linked_vacancies(std::uint32_t host);
  [[nodiscard]] double link_key(std::uint32_t host, const Kind& kind) const;
  bool keep_looking(Vacancy& vacancy) const;
  void work_off(Status& status);
  void report(double key, Status& status);

  FreeSpace& space_;
  std::span<const ShapeIngredient> ingredients_;
  const PackingOptions& options_;
  double longest_side_;
  double spacing_;
  double greatest_depth_;
  PlacedShapes placed_;
  VacancyFitter fitter_;
  std::vector<Kind> kinds_;
  std::vector<std::uint32_t> kind_of_;
  Quota quota_;
  HoleQueue queue_{0};
  std::uint64_t openings_ = 0;
  double first_key_ = 0.0;
  /// Of all that is placed, in cubes of radii.
  double volume_ = 0.0;
  double update_seconds_ = 0.0;
  bool complete_ = true;
};

std::vector<double> quota_weights(std::span<const ShapeIngredient> ingredients, Choose choose) {
  std::vector<double> weights;
  for (const ShapeIngredient& ingredient : ingredients) {
    weights.push_back(choose == Choose::weighted ? ingredient.weight : 1.0);
  }
  return weights;
}

ShapePacker::ShapePacker(const ShapeTarget& target, FreeSpace& space,
                         std::span<const ShapeIngredient> ingredients,
                         const PackingOptions& options)
    : space_(space),
      ingredients_(ingredients),
      options_(options),
      longest_side_(target.target.box().longest_side()),
      spacing_(options.spacing * longest_side_),
      greatest_depth_(space.largest_distance()),
      placed_(target, space, spacing_),
      fitter_(space, placed_, options, spacing_),
      kinds_(kinds_of(ingredients, options, longest_side_)),
      kind_of_(ingredients.size()),
      quota_(quota_weights(ingredients, options.choose)) {
  for (std::uint32_t k = 0; k < kinds_.size(); ++k) {
    for (const std::uint32_t e : kinds_[k].elements) {
      kind_of_[e] = k;
    }
  }
  queue_ = HoleQueue(kinds_.size());
}

/// Two holes nearer than this are one.
double ShapePacker::apart(double clearance) const {
  const double voxel = space_.distances().spacing();
  return std::min(std::max(0.5 * clearance, 1.5 * voxel), 0.035 * longest_side_);
}

double ShapePacker::least_radius(const Kind& kind, const dvec3& at) const {
  // Above 1, it keeps the core's threshold away from the surface, where the outline is drawn.
  constexpr double exponent = 1.5;
  if (options_.threshold_core <= 0.0) {
    return kind.least_radius;
  }
  const DistanceField& depths = space_.target_distances();
  const double depth = depths.value(glm::vec3(depths.steps(at))) / greatest_depth_;
  const double threshold = glm::mix(options_.threshold, options_.threshold_core,
                                    std::pow(glm::clamp(depth, 0.0, 1.0), exponent));
  return std::max(kind.least_radius, threshold * longest_side_);
}

/// An element's thickest part must go into the hole, or next to it.
bool ShapePacker::is_too_small(const Kind& kind, double clearance, const dvec3& at) const {
  const double voxel = space_.distances().spacing();
  const double thickness = std::min(0.5, kind.shape->inscribed().radius);
  return clearance < std::max(0.6 * voxel, 0.7 * thickness * kind.least_radius) ||
         kind.outlook.is_hopeless(clearance, least_radius(kind, at));
}

void ShapePacker::add_vacancy(std::uint32_t k, const FreeSpace::Peak& peak) {
  Kind& kind = kinds_[k];
  const double clearance = peak.distance - spacing_;
  if (is_too_small(kind, clearance, peak.position) ||
      !kind.holes.insert(peak.position, apart(clearance))) {
    return;
  }
  Vacancy vacancy;
  vacancy.hole = peak.position;
  vacancy.listed_at = peak.position;
  vacancy.clearance = clearance;
  vacancy.shape = k;
  vacancy.key =
      std::min(kind.outlook.ratio() * clearance, kind.largest_radius) * kind.key_per_radius;
  queue_.add(vacancy);
}

void ShapePacker::add_holes(const std::vector<FreeSpace::Peak>& peaks) {
  for (const FreeSpace::Peak& peak : peaks) {
    const std::size_t tried = kinds_.size() <= few_kinds ? kinds_.size() : 1;
    Rng rng(options_.seed, choice_stream ^ mix_bits(openings_++));
    const std::size_t first = kinds_.size() > tried ? rng.below(kinds_.size()) : 0;
    for (std::size_t i = 0; i < tried; ++i) {
      add_vacancy(static_cast<std::uint32_t>((first + i) % kinds_.size()), peak);
    }
  }
}

/// Whether a place without a pose is about as large as when it was listed or last opened; if not,
/// what it promises falls with its clearance.
bool ShapePacker::is_as_listed(Vacancy& vacancy) const {
  constexpr double about = 0.8;
  if (vacancy.host) {
    return true;
  }
  const FreeSpace::Peak peak = space_.climb(vacancy.hole);
  const double clearance = peak.distance - spacing_;
  if (clearance >= about * vacancy.clearance) {
    return true;
  }
  vacancy.key *= std::max(0.0, clearance) / vacancy.clearance;
  vacancy.hole = peak.position;
  vacancy.clearance = clearance;
  return false;
}

/// The most promising place of a kind, with a pose that still fits or without one. What has come
/// near since is seen only here, when a place's turn has come: then it is put back for what is left
/// of it, and waits for another turn, as opened at once it would lose the next pose too; or it is
/// given up.
std::optional<ShapePacker::Id> ShapePacker::next_vacancy(std::uint32_t k) {
  constexpr double left = 0.87;
  const Kind& kind = kinds_[k];
  while (const auto id = queue_.top(k)) {
    Vacancy& vacancy = queue_[*id];
    const bool had_pose = vacancy.has_pose;
    if (had_pose ? fitter_.is_ready(vacancy, kind) : is_as_listed(vacancy)) {
      return id;
    }
    queue_.pop(k);
    if (had_pose) {
      vacancy.key *= left;
    } else if (is_too_small(kind, vacancy.clearance, vacancy.hole)) {
      continue;
    }
    queue_.push(*id);
  }
  return std::nullopt;
}

/// The kind to fill the next place with.
std::optional<std::uint32_t> ShapePacker::next_kind() {
  if (options_.choose != Choose::largest) {
    std::vector<char> available(ingredients_.size());
    for (std::size_t e = 0; e < available.size(); ++e) {
      available[e] = queue_.top(kind_of_[e]) ? 1 : 0;
    }
    const auto element = quota_.next(available);
    return element ? std::optional(kind_of_[*element]) : std::nullopt;
  }
  std::optional<std::uint32_t> best;
  double largest = 0.0;
  for (std::uint32_t k = 0; k < kinds_.size(); ++k) {
    const auto top = next_vacancy(k);
    if (top && queue_[*top].key > largest) {
      best = k;
      largest = queue_[*top].key;
    }
  }
  return best;
}

void ShapePacker::open(Vacancy& vacancy, std::uint64_t stream) {
  const Kind& kind = kinds_[vacancy.shape];
  fitter_.open(vacancy, kind, least_radius(kind, vacancy.hole), stream);
  const double preference = vacancy.host ? link_preference : 1.0;
  vacancy.key = preference * vacancy.pose.radius * kind.key_per_radius;
}

/// A ring's opening is worth another look: what starts there is luck.
bool ShapePacker::keep_looking(Vacancy& vacancy) const {
  constexpr int most_openings = 4;
  constexpr double discouraged = 0.7;
  if (!vacancy.host || vacancy.openings >= most_openings) {
    return false;
  }
  vacancy.key = discouraged * link_key(*vacancy.host, kinds_[vacancy.shape]);
  return true;
}

/// Opens the most promising places of a kind that have no pose, at once. Asked to finish, it opens
/// one at a time until something is placed, and none after that.
void ShapePacker::open_batch(std::uint32_t k, const Status& status) {
  constexpr double comparable = 0.6;
  std::array<Id, batch> opened{};
  std::size_t count = 0;
  const double first_key = queue_[*queue_.top(k)].key;
  const std::size_t most =
      status.finish_requested() ? 1 : std::max(least_batch, batch / kinds_.size());
  while (count < most) {
    const auto id = next_vacancy(k);
    if (!id || queue_[*id].key < comparable * first_key || queue_[*id].has_pose) {
      break;
    }
    queue_.pop(k);
    opened[count++] = *id;
  }
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    if (placed_.size() == 0 || !status.finish_requested()) {
      open(queue_[opened[i]], openings_ + i);
    }
  });
  openings_ += count;
  Kind& kind = kinds_[k];
  for (std::size_t i = 0; i < count; ++i) {
    Vacancy& vacancy = queue_[opened[i]];
    if (vacancy.clearance > 0.0) {
      kind.outlook.learn(vacancy.pose.radius / vacancy.clearance);
    }
    if (vacancy.has_pose || keep_looking(vacancy)) {
      queue_.push(opened[i]);
    }
  }
}

/// As if a ring of the host's size would fit.
double ShapePacker::link_key(std::uint32_t host, const Kind& kind) const {
  return link_preference * std::min(placed_.pose(host).radius, kind.largest_radius) *
         kind.key_per_radius;
}

void ShapePacker::add_linked_vacancies(std::uint32_t host) {
  if (placed_.shape(host).ring() == nullptr) {
    return;
  }
  for (std::uint32_t k = 0; k < kinds_.size(); ++k) {
    const Kind& kind = kinds_[k];
    if (kind.shape->ring() == nullptr) {
      continue;
    }
    Vacancy vacancy;
    vacancy.hole = placed_.opening_of(host).center;
    vacancy.shape = k;
    vacancy.host = host;
    vacancy.key = link_key(host, kind);
    queue_.add(vacancy);
  }
}

/// Which of the kind's elements: one that may have this radius, by quota, or by lot.
std::optional<std::uint32_t> ShapePacker::next_element(std::uint32_t k, const Pose& pose) const {
  std::vector<char> available(ingredients_.size(), 0);
  std::vector<std::uint32_t> possible;
  for (const std::uint32_t e : kinds_[k].elements) {
    const double size = ingredients_[e].shape.element().size();
    const bool listed = std::ranges::any_of(
        ingredients_[e].scales, [&](double scale) { return scale * size == pose.radius; });
    if (options_.scaling == Scaling::to_hole || listed) {
      available[e] = 1;
      possible.push_back(e);
    }
  }
  if (options_.choose != Choose::largest) {
    return quota_.farthest_behind(available);
  }
  if (possible.empty()) {
    return std::nullopt;
  }
  Rng rng(options_.seed, placement_stream + placed_.size());
  return possible[rng.below(possible.size())];
}

/// Fills a place whose pose fits by the spheres, if it does exactly.
void ShapePacker::fill(Id id) {
  constexpr double discouraged = 0.85;
  constexpr int most_openings = 6;
  Vacancy& vacancy = queue_[id];
  Kind& kind = kinds_[vacancy.shape];
  queue_.pop(vacancy.shape);
  const double least = least_radius(kind, vacancy.hole);
  const std::optional<Pose> pose = options_.scaling == Scaling::fixed
                                       ? fitter_.settled_at_fixed(kind, vacancy.pose)
                                       : fitter_.settled(kind, vacancy.pose, least);
  vacancy.has_pose = false;
  if (!pose) {
    vacancy.pose = Pose{};
    vacancy.key *= discouraged;
    if (vacancy.openings < most_openings && vacancy.key >= least * kind.key_per_radius) {
      queue_.push(id);
    }
    return;
  }
  const auto element = next_element(vacancy.shape, *pose);
  if (!element) {
    return;
  }
  const Element& made = kind.shape->element();
  double scale = pose->radius / made.size();
  for (const double listed : ingredients_[*element].scales) {
    scale = listed * made.size() == pose->radius ? listed : scale;
  }
  const auto index = static_cast<std::uint32_t>(placed_.size());
  placed_.add(*kind.shape, *pose, pose->instance(*element, made, scale));
  quota_.count(*element);
  volume_ += std::pow(pose->radius * kind.key_per_radius, 3.0);
  const auto host = vacancy.host;
  if (!host) {
    kind.holes.remove(vacancy.listed_at);
  }
  Stopwatch updating;
  space_.add(*kind.shape, *pose, index);
  add_holes(space_.changed_peaks(0.0F));
  if (options_.linking == Linking::seek) {
    add_linked_vacancies(index);
    if (host) {
      add_linked_vacancies(*host);
    }
  }
  update_seconds_ += updating.seconds();
}

/// Keys fall steadily on a scale of logarithms.
void ShapePacker::report(double key, Status& status) {
  if (status.stop_requested()) {
    throw Interrupted();
  }
  if (placed_.size() % 16 != 1) {
    return;
  }
  double last = first_key_;
  for (const Kind& kind : kinds_) {
    last = std::min(last, kind.least_radius * kind.key_per_radius);
  }
  const double fraction =
      last < first_key_ ? std::log(first_key_ / key) / std::log(first_key_ / last) : 0.0;
  status.update(glm::clamp(fraction, 0.0, 1.0),
                fmt::format("{} instances", grouped(placed_.size())));
}

/// Fills places until none is left, or it is asked to finish.
void ShapePacker::work_off(Status& status) {
  while (const auto kind = next_kind()) {
    const auto id = next_vacancy(*kind);
    if (!id) {
      continue;
    }
    first_key_ = std::max(first_key_, queue_[*id].key);
    report(queue_[*id].key, status);
    if (placed_.size() > 0 && status.finish_requested()) {
      complete_ = false;
      return;
    }
    if (queue_[*id].has_pose) {
      fill(*id);
    } else {
      open_batch(*kind, status);
    }
  }
}

/// A hole in which nothing was found is worth another look: what starts there is luck.
Packing ShapePacker::run(Status& status) {
  constexpr int most_sweeps = 2;
  constexpr double worth_a_sweep = 0.002;
  const Stopwatch total;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    for (Kind& kind : kinds_) {
      kind.holes.clear();
    }
    add_holes(space_.peaks(0.0F));
    const double before = volume_;
    work_off(status);
    if (!complete_ || volume_ - before < worth_a_sweep * volume_) {
      break;
    }
  }
  Packing packing;
  packing.complete = complete_;
  packing.instances = placed_.instances();
  packing.voxels = space_.distances().size();
  packing.voxels_inside_target = space_.points_inside_target();
  packing.voxels_inside_instances = space_.points_inside_instances();
  packing.largest_hole = std::max(0.0F, space_.largest_distance());
  packing.update_seconds = update_seconds_;
  packing.place_seconds = total.seconds() - update_seconds_;
  return packing;
}

}  // namespace

Packing pack_by_shape(const ShapeTarget& target, FreeSpace& space,
                      std::span<const ShapeIngredient> ingredients, const PackingOptions& options,
                      Status& status) {
  return ShapePacker(target, space, ingredients, options).run(status);
}

}  // namespace collage
