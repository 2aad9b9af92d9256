#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "fitting/distance_field.h"
#include "fitting/pose.h"
#include "fitting/shaped_element.h"

namespace collage {

/// Signed distances round one place, from each neighbour's own lattice and the target's: finer than
/// those of the whole free space, which do not show what is thinner than a voxel.
class Surroundings {
 public:
  /// Starts anew round a point; most looks will be within `reach` of it. Without a target the space
  /// is endless.
  void reset(const dvec3& origin, double reach, const DistanceField* target);
  void add(const ShapedElement& shape, const Pose& pose);

  [[nodiscard]] bool empty() const { return neighbours_.empty(); }
  [[nodiscard]] glm::vec3 from_origin(const dvec3& point) const {
    return glm::vec3(point - origin_);
  }
  /// At a point given from the origin, with the direction in which the distance grows fastest.
  /// Asked for the first time in a cell, finds out who may be near there, and asks only those from
  /// then on. `nearest` is any number, or a guess as to which neighbour is the nearest, so that
  /// most of the others need no look, and becomes the number of the one that is.
  float value(const glm::vec3& point, glm::vec3& direction, std::uint32_t& nearest);
  /// Distances change by no more than √3 times the way one goes, but on the border of a neighbour's
  /// lattice: there they jump to that from its ball. After such a jump one is no less than this.
  float nearest_jump(const glm::vec3& point) {
    const Cell* cell = cell_at(point);
    return cell != nullptr ? cell->nearest_jump : -1e30F;
  }

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

    [[nodiscard]] glm::vec3 steps(const glm::vec3& arm) const {
      return steps_of_center + steps_from_world * arm;
    }
  };
  struct Cell {
    /// The range of its candidates; of a cell that was not looked into, empty and from 0.
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    float nearest_jump = 0.0F;
  };
  static constexpr int cells_per_side = 16;

  /// Numbers of the neighbours of which one may be the nearest to the point, rising.
  std::span<const std::uint32_t> candidates(const glm::vec3& point);
  /// The point's, looked into; nullptr outside of all, and where neighbours are few.
  const Cell* cell_at(const glm::vec3& point);
  /// Candidates for all points of a cell: all neighbours that are not farther from anywhere in it
  /// than another, or the target, is from everywhere.
  Cell look_into(const glm::vec3& middle);

  dvec3 origin_{0.0};
  const DistanceField* target_ = nullptr;
  std::vector<Neighbour> neighbours_;
  std::vector<std::uint32_t> all_;
  /// Of a cube round the origin.
  float cell_side_ = 1.0F;
  std::vector<Cell> cells_;
  /// The first belongs to no cell.
  std::vector<std::uint32_t> candidates_;
  /// By neighbour, what its distance is at least in the cell that is looked into.
  std::vector<float> least_;
  /// In the cell that was looked into before.
  std::size_t nearest_before_ = 0;
};

}  // namespace collage
