#include "audit/fill.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <tbb/parallel_for.h>

#include "audit/batches.h"
#include "base/rng.h"

namespace collage {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
/// Cells of the grid at most, for targets that are thin for their box.
constexpr double most_cells = 2e7;
/// Rows of the grid between two looks at the clock.
constexpr std::size_t batch = 200;

/// Steps of the growth are at least this far apart, as a factor.
constexpr double step_factor = 1.1;

/// The last step is the whole; none where there are no instances.
std::vector<Fill::Step> growth(const InstanceIndex& sculpture, double target_volume) {
  std::vector<Fill::Step> steps;
  const auto count = static_cast<std::uint32_t>(sculpture.instances().size());
  double volume = 0.0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double scale = sculpture.instances()[i].scale;
    volume += sculpture.solid(i).volume() * scale * scale * scale;
    const double next =
        steps.empty() ? 1.0 : step_factor * static_cast<double>(steps.back().instances);
    if (i + 1 == count || i + 1 >= next) {
      steps.push_back({i + 1, volume / target_volume});
    }
  }
  return steps;
}

struct Point {
  double depth;  // in world units
  bool filled;
};

double box_volume(const Box& box) {
  const dvec3 extent = box.extent();
  return extent.x * extent.y * extent.z;
}

/// Numbers of nearly cubic cells along the sides of a box that make up about `count`, or
/// `most_cells`, but at least one along each.
dvec3 cells_along(const dvec3& extent, double count) {
  count = std::clamp(count, 1.0, most_cells);
  double side = std::cbrt(extent.x * extent.y * extent.z / count);
  dvec3 cells;
  do {
    cells = glm::max(dvec3(1.0), glm::round(extent / side));
    side *= 1.01;
  } while (cells.x * cells.y * cells.z > 1.02 * count);
  return cells;
}

/// A grid over the target's box with one point at random in each cell.
class Grid {
 public:
  /// About `points` of them are in the target.
  Grid(const TargetShape& target, std::size_t points)
      : target_(target),
        size_(cells_along(target.box.extent(), static_cast<double>(points) *
                                                   box_volume(target.box) / target.solid.volume())),
        cell_(target.box.extent() / size_) {}

  [[nodiscard]] std::size_t rows() const { return static_cast<std::size_t>(size_.y * size_.z); }

  /// The points of a row that are inside the target.
  [[nodiscard]] std::vector<Point> points(std::size_t row, const InstanceIndex& sculpture) const {
    const Solid& solid = target_.solid;
    std::vector<Point> found;
    for (std::size_t x = 0; x < static_cast<std::size_t>(size_.x); ++x) {
      const dvec3 point = point_in_cell(x, row);
      const dvec3 unit = solid.unit_from_mesh(point);
      if (solid.inside(unit)) {
        found.push_back({solid.surface().find(unit, unbounded)->distance * solid.radius(),
                         sculpture.holder(point).has_value()});
      }
    }
    return found;
  }

 private:
  [[nodiscard]] dvec3 point_in_cell(std::size_t x, std::size_t row) const {
    const auto rows_of_layer = static_cast<std::size_t>(size_.y);
    Rng rng(0, row * static_cast<std::size_t>(size_.x) + x);
    dvec3 place(x, row % rows_of_layer, row / rows_of_layer);
    for (int axis = 0; axis < 3; ++axis) {
      place[axis] += rng.uniform();
    }
    return target_.box.min + place * cell_;
  }

  const TargetShape& target_;
  /// Cells along each axis, whole numbers.
  dvec3 size_;
  dvec3 cell_;
};

std::vector<Point> points_inside(const TargetShape& target, const InstanceIndex& sculpture,
                                 std::size_t count, Status& status) {
  const Grid grid(target, count);
  std::vector<std::vector<Point>> rows(grid.rows());
  in_batches(rows.size(), batch, "rows of points", status, [&](std::size_t begin, std::size_t end) {
    tbb::parallel_for(begin, end, [&](std::size_t i) { rows[i] = grid.points(i, sculpture); });
  });
  std::vector<Point> all;
  for (const auto& row : rows) {
    all.insert(all.end(), row.begin(), row.end());
  }
  return all;
}

void add(Fill::Sample& sample, const Point& point) {
  ++sample.points;
  sample.filled += point.filled ? 1 : 0;
}

}  // namespace

std::optional<double> Fill::Sample::share() const {
  if (points == 0) {
    return std::nullopt;
  }
  return static_cast<double>(filled) / static_cast<double>(points);
}

std::optional<double> Fill::Sample::deviation() const {
  if (points == 0) {
    return std::nullopt;
  }
  return std::sqrt(*share() * (1.0 - *share()) / static_cast<double>(points));
}

std::optional<Fill> fill(const TargetShape& target, const InstanceIndex& sculpture,
                         const FillOptions& options, Status& status) {
  if (!(target.solid.volume() > 0.0 && box_volume(target.box) > 0.0)) {
    return std::nullopt;
  }
  const std::vector<Point> points = points_inside(target, sculpture, options.points, status);
  double greatest_depth = std::numeric_limits<double>::min();
  for (const Point& point : points) {
    greatest_depth = std::max(greatest_depth, point.depth);
  }
  Fill result;
  result.growth = growth(sculpture, target.solid.volume());
  result.by_volume = result.growth.empty() ? 0.0 : result.growth.back().by_volume;
  result.greatest_depth = greatest_depth / target.side;
  const auto shells = static_cast<double>(result.by_shell.size());
  for (const Point& point : points) {
    const auto shell = static_cast<std::size_t>(shells * (point.depth / greatest_depth));
    add(result.by_points, point);
    add(result.by_shell[std::min(shell, result.by_shell.size() - 1)], point);
  }
  return result;
}

}  // namespace collage
