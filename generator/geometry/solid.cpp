#include "geometry/solid.h"

#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "geometry/topology.h"

namespace collage {

Mesh in_unit_frame(const Mesh& mesh, const dvec3& center, double radius) {
  Mesh unit;
  unit.triangles = mesh.triangles;
  unit.positions.reserve(mesh.positions.size());
  for (const dvec3& position : mesh.positions) {
    unit.positions.push_back((position - center) / radius);
  }
  return unit;
}

/// A cube of `side` cells on a side.
struct Solid::CellBlock {
  int i, j, k, side;

  [[nodiscard]] dvec3 center() const {
    return (dvec3(i, j, k) + 0.5 * side) * (2.0 / cells_per_side) - 1.0;
  }
  [[nodiscard]] double circumradius() const {
    return std::sqrt(3.0) * static_cast<double>(side) / cells_per_side;
  }
};

Solid::Solid(const Mesh& mesh, const dvec3& center, double radius)
    : center_(center),
      radius_(radius),
      surface_(in_unit_frame(mesh, center, radius)),
      winding_number_(in_unit_frame(mesh, center, radius)) {
  if (is_closed(mesh)) {
    crossings_.emplace(in_unit_frame(mesh, center, radius), winding_number_, cells_per_side);
    classify_by_crossings();
  } else {
    classify({0, 0, 0, cells_per_side});
  }
  const Sample sampled = sampled_volume();
  const double unit_volume = radius * radius * radius;
  const double enclosed = enclosed_volume(mesh);
  const bool agree =
      std::abs(enclosed - sampled.volume * unit_volume) <= 3.0 * sampled.deviation * unit_volume;
  volume_ = agree ? enclosed : sampled.volume * unit_volume;
}

/// Decides a block as a whole where no surface is near and the winding number, which varies slowly
/// away from the surface, is close to 0 or 1; else its eight octants.
void Solid::classify(const CellBlock& block) {
  constexpr double clear_of_surface = 1.5;
  constexpr double clear_of_threshold = 0.1;
  const dvec3 center = block.center();
  const double clear = clear_of_surface * block.circumradius();
  if (!surface_.find(center, clear)) {
    const double winding = winding_number_.at(center);
    if (winding < clear_of_threshold || winding > 1.0 - clear_of_threshold) {
      fill(block, winding > 0.5 ? Cell::inside : Cell::outside);
      return;
    }
  }
  if (block.side == 1) {
    fill(block, Cell::mixed);
    return;
  }
  const int half = block.side / 2;
  for (int octant = 0; octant < 8; ++octant) {
    classify({block.i + (octant & 1) * half, block.j + (octant >> 1 & 1) * half,
              block.k + (octant >> 2) * half, half});
  }
}

void Solid::classify_by_crossings() {
  for (std::size_t cell = 0; cell < Cells::size; ++cell) {
    const Cell all = crossings_->winding_at_middle(cell) > 0 ? Cell::inside : Cell::outside;
    cells_.set(cell, crossings_->is_empty(cell) ? all : Cell::mixed);
  }
}

void Solid::fill(const CellBlock& block, Cell state) {
  for (int k = block.k; k < block.k + block.side; ++k) {
    for (int j = block.j; j < block.j + block.side; ++j) {
      for (int i = block.i; i < block.i + block.side; ++i) {
        cells_.set(cell_index(i, j, k), state);
      }
    }
  }
}

bool Solid::inside(const dvec3& unit_point) const {
  const dvec3 cell = (unit_point + 1.0) * (0.5 * cells_per_side);
  const auto in_range = [](double x) { return x >= 0.0 && x < cells_per_side; };
  if (!in_range(cell.x) || !in_range(cell.y) || !in_range(cell.z)) {
    return false;  // outside of the ball that holds the mesh
  }
  const std::size_t index =
      cell_index(static_cast<int>(cell.x), static_cast<int>(cell.y), static_cast<int>(cell.z));
  const Cell state = cells_.at(index);
  if (state != Cell::mixed) {
    return state == Cell::inside;
  }
  if (crossings_) {
    if (const std::optional<int> winding = crossings_->winding_at(index, unit_point)) {
      return *winding > 0;
    }
  }
  return winding_number_.inside(unit_point);
}

Solid::Sample Solid::sampled_volume() const {
  double cells = 0.0;
  double mixed = 0.0;
  for (int k = 0; k < cells_per_side; ++k) {
    for (int j = 0; j < cells_per_side; ++j) {
      for (int i = 0; i < cells_per_side; ++i) {
        const Cell state = cells_.at(cell_index(i, j, k));
        if (state == Cell::mixed) {
          cells += share_inside({i, j, k, 1});
          mixed += 1.0;
        } else {
          cells += state == Cell::inside ? 1.0 : 0.0;
        }
      }
    }
  }
  constexpr double cell_side = 2.0 / cells_per_side;
  constexpr double cell_volume = cell_side * cell_side * cell_side;
  // A share from n samples deviates by at most ½ / √n, and independent cells add in squares.
  const double deviation = std::sqrt(mixed * 0.25 / samples_per_cell);
  return {cells * cell_volume, deviation * cell_volume};
}

/// Share of a cell that lies inside, by one random point in each half (always the same ones).
double Solid::share_inside(const CellBlock& cell) const {
  constexpr double cell_side = 2.0 / cells_per_side;
  Rng rng(0, cell_index(cell.i, cell.j, cell.k));
  int inside = 0;
  for (int half = 0; half < samples_per_cell; ++half) {
    dvec3 offset;
    for (int axis = 0; axis < 3; ++axis) {
      offset[axis] = rng.uniform() - 0.5;
    }
    offset.x = (offset.x + 0.5 + half) / samples_per_cell - 0.5;
    inside += this->inside(cell.center() + cell_side * offset) ? 1 : 0;
  }
  return static_cast<double>(inside) / samples_per_cell;
}

}  // namespace collage
