#pragma once

#include <span>

#include "fitting/free_space.h"
#include "fitting/pose_optimizer.h"

namespace collage {

/// Looks for the largest pose of an element round a hole: several starts, first with few spheres,
/// the best of them with all. One for each thread.
class PoseFinder {
 public:
  struct Request {
    const ShapedElement& shape;
    dvec3 hole;
    /// A pose found smaller than this is of no use.
    double least_radius = 0.0;
    double largest_radius = 1e300;
    /// How many times the usual number of starts, at least 1.
    double effort = 1.0;
    /// What was found here before, or nowhere.
    Pose previous;
  };
  /// A ring to hang another one in.
  struct Opening {
    dvec3 center;
    /// Unit vector through the opening.
    dvec3 axis;
    double radius;
  };

  PoseFinder(const FreeSpace& space, double margin)
      : space_(space), optimizer_(space.distances(), margin) {}

  [[nodiscard]] PoseOptimizer& optimizer() { return optimizer_; }
  /// Poses that are large enough, the largest first; valid until the next call.
  std::span<const Pose> find(const Request& request, Rng& rng);
  /// Starts with the element's own ring through the opening; it need not stay there.
  std::span<const Pose> find_linked(const Request& request, const Opening& opening, Rng& rng);

 private:
  std::span<const Pose> refine(const Request& request, Rng& rng);
  [[nodiscard]] dvec3 longest_chord(const dvec3& hole) const;
  void add_starts(const Request& request, Rng& rng);

  const FreeSpace& space_;
  PoseOptimizer optimizer_;
  std::vector<Pose> poses_;
  std::vector<Pose> found_;
};

}  // namespace collage
