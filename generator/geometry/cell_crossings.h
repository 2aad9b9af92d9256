#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/winding_number.h"

namespace collage {

/// Winding numbers of a closed mesh in the cube from -1 to 1 by what is crossed: along a way within
/// a cell of a grid they change by one for each of the cell's few triangles that it passes through,
/// and where there is none not at all. In each cell the way starts at its middle.
///
/// The signs of determinants decide, in double; where one is too small to be sure of, the winding
/// number is asked. Build O(n + cells), query O(triangles in the cell).
/// Safe to query from many threads.
class CellCrossings {
 public:
  /// `mesh` is closed, as is_closed() has it, and within the unit ball.
  CellCrossings(const Mesh& mesh, const WindingNumber& winding_number, int cells_per_side);

  /// How far the surface stays away from empty cells.
  static constexpr double margin = 1e-4;
  /// Empty cells have the winding number of their middles throughout.
  [[nodiscard]] bool is_empty(std::size_t cell) const { return starts_[cell] == starts_[cell + 1]; }
  [[nodiscard]] int winding_at_middle(std::size_t cell) const { return windings_[cell]; }
  /// Whether a point, and all that are less than `margin` away, are on the same side as the middle
  /// of each of the cell's planes, and so have the same winding number. The point is less than
  /// `margin` out of the cell. Much cheaper than winding_at().
  [[nodiscard]] bool is_beside_middle(std::size_t cell, const glm::vec3& point) const {
    for (std::uint32_t i = starts_[cell]; i < starts_[cell + 1]; ++i) {
      if (!is_beside_middle(planes_[i], point)) {
        return false;
      }
    }
    return true;
  }
  /// At a point in the cell; nothing where the way to it grazes an edge, or it is on the surface.
  [[nodiscard]] std::optional<int> winding_at(std::size_t cell, const dvec3& point) const;

 private:
  using Triangle = std::array<dvec3, 3>;

  [[nodiscard]] dvec3 middle(std::size_t cell) const;
  void list_triangles(const Mesh& mesh);
  void walk_row(std::size_t first, const WindingNumber& winding_number);
  static bool is_beside_middle(const glm::vec4& plane, const glm::vec3& point) {
    constexpr auto clear = static_cast<float>(1.1 * margin);
    return glm::dot(glm::vec3(plane), point) + plane.w > clear;
  }
  /// By how much the winding number changes from a cell's middle to a point of it.
  [[nodiscard]] std::optional<int> change(std::size_t cell, const dvec3& point) const;

  int cells_per_side_;
  std::vector<Triangle> triangles_;
  /// Of a cell: its triangles in `items_` from here to where the next cell's start.
  std::vector<std::uint32_t> starts_;
  std::vector<std::uint32_t> items_;
  /// Of each item: its triangle's plane, as a unit normal towards the cell's middle and the height
  /// of the origin; zeros for a triangle too thin to tell.
  std::vector<glm::vec4> planes_;
  /// At the cells' middles.
  std::vector<std::int16_t> windings_;
};

}  // namespace collage
