#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/closest_point.h"
#include "geometry/four.h"

namespace collage {

/// Bounds on the distance to a mesh in the unit ball round the origin, from grids: about a
/// hundredth of the cost of ClosestPointIndex::find(), which is their slow twin.
///
/// For any set, d² - |x|² is a minimum of linear functions, |q|² - 2 x·q over its points q, and so
/// concave: its trilinear interpolation between nodes is never above it. By how much it can be
/// below follows from the linear functions of the corners' closest points: in a cell of side h at
/// most h/2 Σ Δₖ, where Δₖ is the most by which the closest point moves along k from one end to the
/// other of an edge along k. Both hold across the medial axis too.
///
/// The grids lie in each other, each twice as wide as the last; memory 1 MB.
/// Safe to query from many threads.
class DistanceBounds {
 public:
  /// Bounds on the square of a distance: it is in [lower, lower + gap]; `lower` may be below 0.
  template <class Numbers>
  struct Squared {
    Numbers lower;
    Numbers gap;
  };
  /// Fine: about 32 cells across the ball; coarse, where it covers few voxels: 16, and faster, as
  /// it stays in the nearest cache.
  enum class Detail { fine, coarse };
  /// A query's coordinates must be below this.
  static constexpr float reach = 16.0F;

  /// About 90,000 queries on all threads; 25,000 where `finest` is coarse, which then is all there
  /// is.
  explicit DistanceBounds(const ClosestPointIndex& index, Detail finest = Detail::fine);

  /// The bounds hold for `query` in float arithmetic.
  [[nodiscard]] Squared<float> squared(const glm::vec3& query, Detail detail) const {
    const float farthest = std::max({std::abs(query.x), std::abs(query.y), std::abs(query.z)});
    const std::vector<Grid>& grids = detail == Detail::fine ? fine_ : coarse_;
    std::size_t level = 0;
    while (farthest >= grids[level].half_side) {
      ++level;
    }
    return grids[level].squared(query);
  }
  /// The same of four at once.
  [[nodiscard]] Squared<Four> squared(const Points<Four>& queries, Detail detail) const {
    const Four farthest =
        larger(larger(absolute(queries[0]), absolute(queries[1])), absolute(queries[2]));
    constexpr std::int32_t exponent_of_half = 126;
    const FourIntegers beyond = (std::bit_cast<FourIntegers>(farthest) >> 23) - exponent_of_half;
    const FourIntegers level = beyond > 0 ? beyond : FourIntegers{};
    const Grid* grids = (detail == Detail::fine ? fine_ : coarse_).data();
    return Grid::squared({grids + level[0], grids + level[1], grids + level[2], grids + level[3]},
                         queries);
  }
  /// A triangle that is likely to be among the nearest, to begin an exact search with.
  [[nodiscard]] std::uint32_t hint(const dvec3& query) const;

 private:
  struct Node {
    double squared_distance;
    dvec3 closest;
    std::uint32_t triangle;
  };
  /// A cube about the origin.
  class Grid {
   public:
    Grid(float half_width, int cells, const std::vector<Node>& nodes, int stride);
    /// The triangle of a node near the query, or near that end of the grid.
    [[nodiscard]] std::uint32_t hint(const dvec3& query) const;
    [[nodiscard]] Squared<float> squared(const glm::vec3& query) const {
      const glm::vec3 at = (query + half_side) * cells_per_unit_;
      const glm::ivec3 cell = glm::min(glm::ivec3(at), cells_ - 1);  // rounding may lead beyond
      const glm::vec3 t = at - glm::vec3(cell);
      const std::ptrdiff_t row = cells_ + 1;
      const float* node = concave_.data() + (cell.z * row + cell.y) * row + cell.x;
      const auto along_x = [&t](const float* from) { return from[0] + (from[1] - from[0]) * t.x; };
      const auto along_y = [&](const float* from) {
        const float first = along_x(from);
        return first + (along_x(from + row) - first) * t.y;
      };
      const std::ptrdiff_t gap_index = (cell.z * (row - 1) + cell.y) * (row - 1) + cell.x;
      const float first = along_y(node);
      const float concave = first + (along_y(node + row * row) - first) * t.z;
      return {concave + glm::dot(query, query),
              std::bit_cast<float>(std::uint32_t{gap_.data()[gap_index]} << 16)};
    }
    /// Of each query by a grid of its own.
    static Squared<Four> squared(const std::array<const Grid*, four_lanes>& grids,
                                 const Points<Four>& queries) {
      const Four half_side{grids[0]->half_side, grids[1]->half_side, grids[2]->half_side,
                           grids[3]->half_side};
      const Four cells_per_unit{grids[0]->cells_per_unit_, grids[1]->cells_per_unit_,
                                grids[2]->cells_per_unit_, grids[3]->cells_per_unit_};
      const FourIntegers last{grids[0]->cells_ - 1, grids[1]->cells_ - 1, grids[2]->cells_ - 1,
                              grids[3]->cells_ - 1};
      std::array<FourIntegers, 3> cell;
      Points<Four> t;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const Four at = (queries[axis] + half_side) * cells_per_unit;
        cell[axis] = __builtin_convertvector(at, FourIntegers);
        cell[axis] = cell[axis] < last ? cell[axis] : last;
        t[axis] = at - __builtin_convertvector(cell[axis], Four);
      }
      std::array<const float*, four_lanes> nodes;
      std::array<std::ptrdiff_t, four_lanes> rows;
      FourIntegers gaps;
      for (std::size_t lane = 0; lane < four_lanes; ++lane) {
        const Grid& grid = *grids[lane];
        const std::ptrdiff_t cells = grid.cells_;
        const std::ptrdiff_t row = cells + 1;
        rows[lane] = row;
        nodes[lane] =
            grid.concave_.data() + (cell[2][lane] * row + cell[1][lane]) * row + cell[0][lane];
        const auto gap = (cell[2][lane] * cells + cell[1][lane]) * cells + cell[0][lane];
        gaps[lane] = grid.gap_.data()[gap] << 16;
      }
      const auto along_x = [&](std::ptrdiff_t y, std::ptrdiff_t z) {
        const auto pair = [&](std::size_t lane) {
          return pair_at(nodes[lane] + (z * rows[lane] + y) * rows[lane]);
        };
        const auto [from, to] = transposed(pair(0), pair(1), pair(2), pair(3));
        return from + (to - from) * t[0];
      };
      const auto along_y = [&](std::ptrdiff_t z) {
        const Four from = along_x(0, z);
        return from + (along_x(1, z) - from) * t[1];
      };
      const Four from = along_y(0);
      const Four concave = from + (along_y(1) - from) * t[2];
      return {concave + dot(queries, queries), std::bit_cast<Four>(gaps)};
    }

    float half_side;

   private:
    int cells_;
    float cells_per_unit_;
    /// d² - |x|² at the nodes, rounded down.
    std::vector<float> concave_;
    /// The upper halves of floats, rounded up.
    std::vector<std::uint16_t> gap_;
    std::vector<std::uint32_t> triangles_;
  };

  static std::vector<Node> sample(const ClosestPointIndex& index, double half_side, int cells);

  std::vector<Grid> fine_;
  std::vector<Grid> coarse_;
};

}  // namespace collage
