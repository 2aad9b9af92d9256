#include "packing/pack.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

#include "base/error.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "packing/orientation.h"
#include "packing/update.h"

namespace collage {
namespace {

class Packer {
 public:
  Packer(const Target& target, ClearanceField& field, std::span<const Ingredient> ingredients,
         const PackingOptions& options)
      : target_(target),
        field_(field),
        ingredients_(ingredients),
        options_(options),
        longest_side_(target.box().longest_side()),
        chooser_(candidates(ingredients), options) {}

  Packing run(Status& status);

 private:
  static std::vector<Chooser::Candidate> candidates(std::span<const Ingredient> ingredients) {
    std::vector<Chooser::Candidate> list;
    for (const Ingredient& ingredient : ingredients) {
      list.push_back({ingredient.element.size(), ingredient.scales, ingredient.weight});
    }
    return list;
  }

  /// The radius of the ball that an element may take in a hole.
  [[nodiscard]] double room(const Hole& hole) const {
    return hole.clearance - options_.spacing * longest_side_;
  }
  [[nodiscard]] std::optional<Instance> place(const Hole& hole) const;
  [[nodiscard]] dvec3 direction_to_surface(const Hole& hole) const;
  void report(const Hole& hole, double first_room, Status& status) const;

  const Target& target_;
  ClearanceField& field_;
  std::span<const Ingredient> ingredients_;
  const PackingOptions& options_;
  double longest_side_;
  Chooser chooser_;
  std::vector<Instance> instances_;
};

Packing Packer::run(Status& status) {
  Packing packing;
  Stopwatch total;
  const double threshold = options_.threshold * longest_side_;
  Hole hole = field_.largest_hole();
  const double first_room = room(hole);
  while (room(hole) >= threshold) {
    const std::optional<Instance> instance = place(hole);
    if (!instance) {
      break;  // every element is larger than the largest hole
    }
    instances_.push_back(*instance);
    Stopwatch updating;
    packing.voxels_inside_instances +=
        update(field_, ingredients_[instance->element].element, *instance,
               static_cast<SurfaceId>(instances_.size()), hole.clearance);
    packing.update_seconds += updating.seconds();
    report(hole, first_room, status);
    hole = field_.largest_hole();
  }
  packing.instances = std::move(instances_);
  packing.voxels = field_.grid().size;
  packing.voxels_inside_target = field_.voxels_inside();
  packing.largest_hole = std::max(0.0, hole.clearance);
  packing.place_seconds = total.seconds() - packing.update_seconds;
  return packing;
}

std::optional<Instance> Packer::place(const Hole& hole) const {
  Rng rng(options_.seed, placement_stream + instances_.size());
  const std::optional<Choice> choice = chooser_.choose(room(hole), instances_.size(), rng);
  if (!choice) {
    return std::nullopt;
  }
  const Element& element = ingredients_[choice->element].element;
  const double spin_radians = glm::two_pi<double>() * rng.uniform();
  Instance instance;
  instance.element = choice->element;
  instance.scale = choice->scale;
  instance.rotation =
      orientation(element.farthest_direction(), direction_to_surface(hole), spin_radians);
  instance.translation = hole.center - instance.rotation * (choice->scale * element.center());
  return instance;
}

dvec3 Packer::direction_to_surface(const Hole& hole) const {
  if (hole.nearest == target_surface) {
    return target_.direction_to_surface(hole.center);
  }
  const Instance& neighbour = instances_[hole.nearest - 1];
  const Solid& solid = ingredients_[neighbour.element].element.solid();
  const dvec3 in_mesh =
      glm::conjugate(neighbour.rotation) * (hole.center - neighbour.translation) / neighbour.scale;
  const dvec3 unit = solid.unit_from_mesh(in_mesh);
  const auto closest = solid.surface().find(unit, std::numeric_limits<double>::infinity());
  return glm::normalize(neighbour.rotation * (closest->point - unit));
}

/// Holes shrink steadily on a scale of logarithms, and each octave of them costs about the same.
void Packer::report(const Hole& hole, double first_room, Status& status) const {
  if (instances_.size() % 64 != 1) {
    return;
  }
  if (status.stop_requested()) {
    throw Interrupted();
  }
  const double threshold = options_.threshold * longest_side_;
  const double fraction = std::log(first_room / room(hole)) / std::log(first_room / threshold);
  status.update(std::min(fraction, 1.0), fmt::format("{} instances", grouped(instances_.size())));
}

}  // namespace

Packing pack(const Target& target, ClearanceField& field, std::span<const Ingredient> ingredients,
             const PackingOptions& options, Status& status) {
  return Packer(target, field, ingredients, options).run(status);
}

double fill(const Target& target, std::span<const Ingredient> ingredients,
            std::span<const Instance> instances) {
  double volume = 0.0;
  for (const Instance& instance : instances) {
    const double scale = instance.scale;
    volume += scale * scale * scale * ingredients[instance.element].element.solid().volume();
  }
  return volume / target.volume();
}

}  // namespace collage
