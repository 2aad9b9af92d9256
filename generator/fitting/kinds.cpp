#include "fitting/kinds.h"

#include <cmath>

namespace collage {

std::vector<Kind> kinds_of(std::span<const ShapeIngredient> ingredients,
                           const PackingOptions& options, double longest_side) {
  constexpr double nearly = 0.99;  // scales are often rounded to the threshold
  std::vector<Kind> kinds;
  const double threshold = options.threshold * longest_side;
  for (std::uint32_t e = 0; e < ingredients.size(); ++e) {
    const ShapeIngredient& ingredient = ingredients[e];
    const auto known = std::ranges::find(kinds, &ingredient.shape, &Kind::shape);
    const auto k = static_cast<std::size_t>(known - kinds.begin());
    if (known == kinds.end()) {
      Kind& kind = kinds.emplace_back();
      kind.shape = &ingredient.shape;
      kind.key_per_radius = std::max(0.05, std::cbrt(ingredient.shape.unit_volume()));
      kind.least_radius = threshold;
      kind.largest_radius = options.largest * longest_side;
      kind.holes = HoleMap(0.01 * longest_side);
    }
    Kind& kind = kinds[k];
    kind.elements.push_back(e);
    for (const double scale : ingredient.scales) {
      const double radius = scale * ingredient.shape.element().size();
      if (options.scaling == Scaling::fixed && radius >= nearly * threshold) {
        kind.radii.push_back(radius);
      }
    }
  }
  for (Kind& kind : kinds) {
    kind.share = 1.0 / static_cast<double>(kinds.size());
    if (options.scaling == Scaling::fixed) {
      std::ranges::sort(kind.radii, std::ranges::greater{});
      kind.least_radius = kind.radii.empty() ? 1e300 : kind.radii.back();
      kind.largest_radius = kind.radii.empty() ? 0.0 : kind.radii.front();
    }
  }
  return kinds;
}

}  // namespace collage
