#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "fitting/distance_field.h"
#include "fitting/pose.h"
#include "fitting/shaped_element.h"

namespace collage {

/// Signed distances round one place, from each neighbour's own lattice and the target's: finer than
/// those of the whole free space, which do not show what is thinner than a voxel.
class Surroundings {
 public:
  /// Starts anew round a point. Without a target the space is endless.
  void reset(const dvec3& origin, const DistanceField* target) {
    origin_ = origin;
    target_ = target;
    neighbours_.clear();
  }
  void add(const ShapedElement& shape, const Pose& pose);

  [[nodiscard]] bool empty() const { return neighbours_.empty(); }
  [[nodiscard]] glm::vec3 from_origin(const dvec3& point) const {
    return glm::vec3(point - origin_);
  }
  /// At a point given from the origin, with the direction in which the distance grows fastest.
  /// `nearest` is any number, or a guess as to which neighbour is the nearest, so that most of the
  /// others need no look, and becomes the number of the one that is.
  float value(const glm::vec3& point, glm::vec3& direction, std::uint32_t& nearest) const;

 private:
  struct Neighbour {
    const DistanceField* distances;
    const DistanceMinima* minima;
    glm::vec3 center;
    float radius;
    glm::mat3 world_from_unit;
    /// From world to steps of its lattice.
    glm::mat3 steps_from_world;
    glm::vec3 steps_of_center;
  };

  dvec3 origin_{0.0};
  const DistanceField* target_ = nullptr;
  std::vector<Neighbour> neighbours_;
};

}  // namespace collage
