#include "packing/placer.h"

#include <algorithm>
#include <limits>

#include <glm/gtc/constants.hpp>

#include "packing/orientation.h"
#include "packing/rounding.h"

namespace collage {
namespace {

std::vector<Chooser::Candidate> candidates(std::span<const Ingredient> ingredients) {
  std::vector<Chooser::Candidate> list;
  for (const Ingredient& ingredient : ingredients) {
    list.push_back({ingredient.element.size(), ingredient.scales, ingredient.weight,
                    ingredient.left, ingredient.right});
  }
  return list;
}

/// Radius of the smallest ball that an element can take.
double smallest_size(std::span<const Ingredient> ingredients, Scaling scaling) {
  if (scaling == Scaling::to_hole) {
    return 0.0;
  }
  double smallest = std::numeric_limits<double>::infinity();
  for (const Ingredient& ingredient : ingredients) {
    for (const double scale : ingredient.scales) {
      smallest = std::min(smallest, scale * ingredient.element.size());
    }
  }
  return smallest;
}

}  // namespace

Placer::Placer(std::span<const Ingredient> ingredients, const PackingOptions& options,
               const Box& target_box)
    : ingredients_(ingredients),
      chooser_(candidates(ingredients), options),
      seed_(options.seed),
      left_(target_box.min.x),
      width_(target_box.extent().x),
      spacing_(options.spacing * target_box.longest_side()),
      least_clearance_(rounded_down(
          (1.0 - 1e-9) * (spacing_ + std::max(options.threshold * target_box.longest_side(),
                                              smallest_size(ingredients, options.scaling))))) {}

std::optional<Instance> Placer::place(const Hole& hole, std::size_t index,
                                      const Surfaces& surfaces) const {
  Rng rng(seed_, placement_stream + index);
  const double across = width_ > 0.0 ? (hole.center.x - left_) / width_ : 0.5;
  const std::optional<Choice> choice =
      chooser_.choose(hole.clearance - spacing_, index, rng, across);
  if (!choice) {
    return std::nullopt;
  }
  const Element& element = ingredients_[choice->element].element;
  const double spin_radians = glm::two_pi<double>() * rng.uniform();
  Instance instance;
  instance.element = choice->element;
  instance.scale = choice->scale;
  instance.rotation =
      orientation(element.farthest_direction(),
                  surfaces.direction(hole.nearest, hole.center, hole.clearance), spin_radians);
  instance.translation = hole.center - instance.rotation * (choice->scale * element.center());
  return instance;
}

}  // namespace collage
