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
  /// At a point in the cell; nothing where the way to it grazes an edge, or it is on the surface.
  [[nodiscard]] std::optional<int> winding_at(std::size_t cell, const dvec3& point) const;

 private:
  using Triangle = std::array<dvec3, 3>;

  [[nodiscard]] dvec3 middle(std::size_t cell) const;
  void list_triangles(const Mesh& mesh);
  void walk_row(std::size_t first, const WindingNumber& winding_number);
  /// By how much the winding number changes from one point of a cell to another.
  [[nodiscard]] std::optional<int> change(std::size_t cell, const dvec3& from,
                                          const dvec3& to) const;

  int cells_per_side_;
  std::vector<Triangle> triangles_;
  /// Of a cell: its triangles in `items_` from here to where the next cell's start.
  std::vector<std::uint32_t> starts_;
  std::vector<std::uint32_t> items_;
  /// At the cells' middles.
  std::vector<std::int16_t> windings_;
};

}  // namespace collage
