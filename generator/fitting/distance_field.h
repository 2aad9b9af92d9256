#pragma once

#include <cstddef>
#include <vector>

#include "geometry/solid.h"

namespace collage {

/// Signed distances to a surface at the points of a cubic lattice, positive in free space, and
/// trilinear in between. Positions are given in steps of the lattice, from its first point. Reading
/// is safe from many threads.
class DistanceField {
 public:
  DistanceField() = default;
  /// `first` is the lattice's first point, `size` ≥ 2 its number of points on each axis.
  DistanceField(const dvec3& first, double spacing, const glm::ivec3& size)
      : first_(first),
        spacing_(spacing),
        size_(size),
        row_(static_cast<std::size_t>(size.x)),
        layer_(row_ * size.y),
        values_(layer_ * size.z) {}

  [[nodiscard]] const dvec3& first() const { return first_; }
  [[nodiscard]] double spacing() const { return spacing_; }
  [[nodiscard]] const glm::ivec3& size() const { return size_; }
  [[nodiscard]] dvec3 point(const glm::ivec3& p) const { return first_ + spacing_ * dvec3(p); }
  [[nodiscard]] dvec3 steps(const dvec3& point) const { return (point - first_) / spacing_; }
  [[nodiscard]] bool holds(const glm::vec3& steps) const {
    const glm::vec3 last(size_ - 1);
    return steps.x >= 0.0F && steps.y >= 0.0F && steps.z >= 0.0F && steps.x < last.x &&
           steps.y < last.y && steps.z < last.z;
  }

  [[nodiscard]] std::size_t index(const glm::ivec3& p) const {
    return p.z * layer_ + p.y * row_ + static_cast<std::size_t>(p.x);
  }
  [[nodiscard]] float& at(const glm::ivec3& p) { return values_[index(p)]; }
  [[nodiscard]] float at(const glm::ivec3& p) const { return values_[index(p)]; }
  [[nodiscard]] const std::vector<float>& values() const { return values_; }
  [[nodiscard]] std::vector<float>& values() { return values_; }

  /// Outside of the lattice, as at its nearest point.
  [[nodiscard]] float value(const glm::vec3& steps) const {
    const Cell cell = cell_at(steps);
    const float* v = &values_[cell.index];
    const float front =
        mix(mix(v[0], v[1], cell.part.x), mix(v[row_], v[row_ + 1], cell.part.x), cell.part.y);
    const float* w = v + layer_;
    const float back =
        mix(mix(w[0], w[1], cell.part.x), mix(w[row_], w[row_ + 1], cell.part.x), cell.part.y);
    return mix(front, back, cell.part.z);
  }
  /// The same, with the direction in which the distance grows fastest, a unit vector.
  float value(const glm::vec3& steps, glm::vec3& direction) const;

  /// Makes the distances change by no more than the way one goes, as those to a surface without
  /// gaps do: where an open surface has its inside end in empty space, the sign jumps between
  /// points that both are far from the surface, and this puts a surface between them.
  void close_gaps();

 private:
  struct Cell {
    std::size_t index;
    glm::vec3 part;
  };
  static float mix(float a, float b, float part) { return a + (b - a) * part; }
  [[nodiscard]] Cell cell_at(const glm::vec3& steps) const {
    const glm::vec3 last = glm::vec3(size_) - 1.001F;
    const glm::vec3 inside = glm::clamp(steps, glm::vec3(0.0F), last);
    const glm::ivec3 corner(inside);
    return {index(corner), inside - glm::vec3(corner)};
  }
  void limit(const glm::ivec3& p, const glm::ivec3& neighbour);

  dvec3 first_{0.0};
  double spacing_ = 1.0;
  glm::ivec3 size_{0};
  std::size_t row_ = 0;
  std::size_t layer_ = 0;
  std::vector<float> values_;
};

/// Lower bounds of a field, one number for many cells, so that most looks at the field itself can
/// be spared.
class DistanceMinima {
 public:
  DistanceMinima() = default;
  explicit DistanceMinima(const DistanceField& field);

  /// No more than the field's value at a place that it holds.
  [[nodiscard]] float below(const glm::vec3& steps) const {
    const glm::ivec3 block = glm::ivec3(steps) / cells;
    const int index = (block.z * blocks_.y + block.y) * blocks_.x + block.x;
    return values_[static_cast<std::size_t>(index)];
  }

 private:
  /// On a block's side.
  static constexpr int cells = 4;

  glm::ivec3 blocks_{0};
  std::vector<float> values_;
};

/// Distances to a solid in its unit frame, negative inside, over the cube that reaches `margin`
/// beyond the unit ball. Runs on all threads. Cost: a closest-point query and an inside test a
/// point.
DistanceField sample_unit_distances(const Solid& solid, int points_per_side, double margin);

}  // namespace collage
