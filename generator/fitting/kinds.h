#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "fitting/hole_queue.h"
#include "fitting/shaped_element.h"
#include "packing/options.h"

namespace collage {

/// An element with what the scene says about its use. Elements of the same mesh share one shape.
struct ShapeIngredient {
  const ShapedElement& shape;
  std::vector<double> scales{1.0};
  double weight = 1.0;
};

/// Guesses how large a pose a hole will turn out to have: what six in ten have stayed below, in
/// units of the hole's clearance. A higher guess has holes opened long before their turn, and most
/// of the poses lost again.
class Outlook {
 public:
  [[nodiscard]] double ratio() const { return ratio_; }
  /// Hardly one in a hundred holes that look like this has room for a pose of radius `least`.
  [[nodiscard]] bool is_hopeless(double clearance, double least) const {
    constexpr double share_of_least = 0.4;
    return has_learned_ && ratio_ * clearance < share_of_least * least;
  }
  void learn(double ratio) {
    seen_.push_back(ratio);
    if (seen_.size() == sample) {
      std::ranges::nth_element(seen_, seen_.begin() + share);
      ratio_ = std::max(1.2, seen_[share]);
      has_learned_ = true;
      seen_.clear();
    }
  }

 private:
  static constexpr std::ptrdiff_t sample = 100;
  static constexpr std::ptrdiff_t share = 60;
  double ratio_ = 2.0;
  bool has_learned_ = false;
  std::vector<double> seen_;
};

/// A shape with all that depends on the options.
struct Kind {
  const ShapedElement* shape;
  /// Key of a pose ÷ its radius: keys are cube roots of volumes.
  double key_per_radius = 1.0;
  double least_radius = 0.0;
  double largest_radius = 1e300;
  /// Of the radii allowed, falling; empty: any.
  std::vector<double> radii;
  std::vector<std::uint32_t> elements;
  /// Of the effort that is spent on a hole, the same for all kinds.
  double share = 1.0;
  Outlook outlook;
  HoleMap holes{1.0};
};

/// One for each shape, in the order in which the ingredients first have it.
std::vector<Kind> kinds_of(std::span<const ShapeIngredient> ingredients,
                           const PackingOptions& options, double longest_side);

}  // namespace collage
