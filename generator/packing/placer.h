#pragma once

#include <optional>
#include <span>
#include <vector>

#include "packing/choose.h"
#include "packing/clearance_field.h"
#include "packing/surfaces.h"

namespace collage {

/// Instance n draws its random numbers from stream `placement_stream` + n.
inline constexpr std::uint64_t placement_stream = 0x706c6163656d656eULL;

/// An element with what the scene says about its use.
struct Ingredient {
  const Element& element;
  std::vector<double> scales{1.0};
  double weight = 1.0;
  /// As Chooser::Candidate.
  double left = 0.0;
  double right = 1.0;
};

/// Chooses an element for a hole and turns it (Muhm 2011, III.3.1 and IV.1).
class Placer {
 public:
  /// `target_box` is that of its surface. The ingredients must outlive this.
  Placer(std::span<const Ingredient> ingredients, const PackingOptions& options,
         const Box& target_box);

  /// A hole of less clearance than this stays empty.
  [[nodiscard]] float least_clearance() const { return least_clearance_; }
  /// For the hole of instance `index`; nothing where every element that may lie there is larger.
  [[nodiscard]] std::optional<Instance> place(const Hole& hole, std::size_t index,
                                              const Surfaces& surfaces) const;
  /// Whether an element would fit such a hole, were it elsewhere.
  [[nodiscard]] bool fits_elsewhere(const Hole& hole) const {
    return chooser_.fits(hole.clearance - spacing_);
  }

 private:
  std::span<const Ingredient> ingredients_;
  Chooser chooser_;
  std::uint64_t seed_;
  double left_;
  double width_;
  double spacing_;
  float least_clearance_;
};

}  // namespace collage
