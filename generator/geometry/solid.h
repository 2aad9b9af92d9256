#pragma once

#include <optional>
#include <vector>

#include "geometry/cell_crossings.h"
#include "geometry/closest_point.h"
#include "geometry/mesh.h"
#include "geometry/winding_number.h"

namespace collage {

/// Positions and triangles of `mesh`, moved and scaled so that the given ball becomes the unit
/// ball.
Mesh in_unit_frame(const Mesh& mesh, const dvec3& center, double radius);

/// A mesh seen as the solid that it bounds, in a unit frame of its own: a given ball round the mesh
/// becomes the unit ball, so that float structures keep their precision whatever the mesh's size
/// and place. Inside is where the generalised winding number exceeds one half, so that open and
/// self-intersecting meshes are solids too. Safe to query from many threads.
class Solid {
 public:
  /// The ball of `center` and `radius` must hold the mesh; `radius` > 0.
  /// Costs about as much as 100,000 queries where the mesh is open, much less where it is closed.
  Solid(const Mesh& mesh, const dvec3& center, double radius);

  [[nodiscard]] const dvec3& center() const { return center_; }
  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] dvec3 unit_from_mesh(const dvec3& point) const {
    return (point - center_) / radius_;
  }
  [[nodiscard]] dvec3 mesh_from_unit(const dvec3& point) const { return radius_ * point + center_; }

  /// All of these in the unit frame.
  [[nodiscard]] const ClosestPointIndex& surface() const { return surface_; }
  [[nodiscard]] bool inside(const dvec3& unit_point) const;
  /// What inside() is of all points less than `cell_margin` from one within the unit ball; nothing
  /// where the surface may be near.
  [[nodiscard]] std::optional<bool> inside_by_cell(const glm::vec3& unit_point) const {
    const glm::ivec3 cell((unit_point + 1.0F) * (0.5F * cells_per_side));
    const glm::ivec3 nearest = glm::min(cell, cells_per_side - 1);
    const std::size_t index = cell_index(nearest.x, nearest.y, nearest.z);
    const Cell state = cells_.at(index);
    if (state != Cell::mixed) {
      return state == Cell::inside;
    }
    if (crossings_ && crossings_->is_beside_middle(index, unit_point)) {
      return crossings_->winding_at_middle(index) > 0;
    }
    return std::nullopt;
  }
  static constexpr double cell_margin = 0.9 * CellCrossings::margin;
  /// By the winding number alone: the slow twin of inside().
  [[nodiscard]] bool inside_by_winding_number(const dvec3& unit_point) const {
    return winding_number_.inside(unit_point);
  }

  /// Volume of the solid in the mesh's units: by the divergence theorem where that agrees with a
  /// sample on the cells within its deviation, as for closed meshes whose parts do not overlap;
  /// else the sample, right to about 0.5 %, for thin solids 2 %.
  [[nodiscard]] double volume() const { return volume_; }

 private:
  enum class Cell : std::uint8_t { outside, inside, mixed };
  /// Cells on a side of the cube round the unit ball; a power of two.
  static constexpr int cells_per_side = 64;
  static constexpr int samples_per_cell = 2;

  /// Four to a byte, so that they stay in the nearer caches.
  class Cells {
   public:
    [[nodiscard]] Cell at(std::size_t index) const {
      return static_cast<Cell>(bytes_[index / 4] >> index % 4 * 2 & 3);
    }
    void set(std::size_t index, Cell state) {
      std::uint8_t& byte = bytes_[index / 4];
      const auto shift = index % 4 * 2;
      const unsigned others = byte & ~(3U << shift);
      byte = static_cast<std::uint8_t>(others | static_cast<unsigned>(state) << shift);
    }
    static constexpr std::size_t size =
        static_cast<std::size_t>(cells_per_side) * cells_per_side * cells_per_side;

   private:
    std::vector<std::uint8_t> bytes_ = std::vector<std::uint8_t>(size / 4);
  };

  struct CellBlock;
  void classify(const CellBlock& block);
  void classify_by_crossings();
  void fill(const CellBlock& block, Cell state);
  /// A volume in the unit frame with its standard deviation.
  struct Sample {
    double volume;
    double deviation;
  };
  [[nodiscard]] Sample sampled_volume() const;
  [[nodiscard]] double share_inside(const CellBlock& cell) const;
  [[nodiscard]] static std::size_t cell_index(int i, int j, int k) {
    return (static_cast<std::size_t>(k) * cells_per_side + j) * cells_per_side + i;
  }

  dvec3 center_;
  double radius_;
  ClosestPointIndex surface_;
  WindingNumber winding_number_;
  /// Of a closed mesh.
  std::optional<CellCrossings> crossings_;
  /// Where a cell holds no surface the winding number need not be asked.
  Cells cells_;
  double volume_ = 0.0;
};

}  // namespace collage
