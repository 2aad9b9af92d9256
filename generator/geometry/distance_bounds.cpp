#include "geometry/distance_bounds.h"

#include <algorithm>
#include <limits>

#include <tbb/parallel_for.h>

namespace collage {
namespace {

constexpr int nearest_cells = 32;
constexpr int far_cells = 16;
/// Grids up to this half side have `nearest_cells`.
constexpr int near_half_side = 2;

std::size_t node_index(const glm::ivec3& node, int cells) {
  const std::size_t row = static_cast<std::size_t>(cells) + 1;
  return (static_cast<std::size_t>(node.z) * row + static_cast<std::size_t>(node.y)) * row +
         static_cast<std::size_t>(node.x);
}

}  // namespace

DistanceBounds::DistanceBounds(const ClosestPointIndex& index, Detail finest) {
  for (int half_side = 1; static_cast<float>(half_side) <= reach; half_side *= 2) {
    const bool is_fine = finest == Detail::fine && half_side <= near_half_side;
    const int cells = is_fine ? nearest_cells : far_cells;
    const std::vector<Node> nodes = sample(index, half_side, cells);
    const auto half_width = static_cast<float>(half_side);
    fine_.emplace_back(half_width, cells, nodes, 1);
    coarse_.emplace_back(half_width, far_cells, nodes, cells / far_cells);
  }
}

std::vector<DistanceBounds::Node> DistanceBounds::sample(const ClosestPointIndex& index,
                                                         double half_side, int cells) {
  const int row = cells + 1;
  std::vector<Node> nodes(static_cast<std::size_t>(row) * row * row);
  const double side = 2.0 * half_side / cells;
  tbb::parallel_for(0, row * row, [&](int yz) {
    double reach = std::numeric_limits<double>::infinity();
    for (int x = 0; x < row; ++x) {
      const glm::ivec3 at(x, yz % row, yz / row);
      const dvec3 point = side * dvec3(at) - half_side;
      const auto closest = index.find(point, reach);
      nodes[node_index(at, cells)] = {closest->distance * closest->distance, closest->point,
                                      closest->triangle};
      reach = closest->distance + 1.001 * side;
    }
  });
  return nodes;
}

std::uint32_t DistanceBounds::hint(const dvec3& query) const {
  const double farthest = std::max({std::abs(query.x), std::abs(query.y), std::abs(query.z)});
  std::size_t level = 0;
  while (level + 1 < fine_.size() && farthest >= fine_[level].half_side) {
    ++level;
  }
  return fine_[level].hint(query);
}

std::uint32_t DistanceBounds::Grid::hint(const dvec3& query) const {
  const dvec3 at =
      glm::round((query + static_cast<double>(half_side)) * static_cast<double>(cells_per_unit_));
  const glm::ivec3 node(glm::clamp(at, dvec3(0.0), dvec3(cells_)));
  return triangles_[node_index(node, cells_)];
}

DistanceBounds::Grid::Grid(float half_width, int cells, const std::vector<Node>& nodes, int stride)
    : half_side(half_width),
      cells_(cells),
      cells_per_unit_(static_cast<float>(cells) / (2.0F * half_width)) {
  // Of a value up to (1 + √3 half side)², float arithmetic loses a dozen units in the last place.
  const double scale = 1.0 + std::sqrt(3.0) * half_side;
  const double rounding = 16.0 * 0x1p-24 * scale * scale;
  const double side = 2.0 * half_side / cells;
  const auto node = [&](const glm::ivec3& at) -> const Node& {
    return nodes[node_index(at * stride, cells * stride)];
  };
  glm::ivec3 at;
  for (at.z = 0; at.z <= cells; ++at.z) {
    for (at.y = 0; at.y <= cells; ++at.y) {
      for (at.x = 0; at.x <= cells; ++at.x) {
        const dvec3 point = side * dvec3(at) - static_cast<double>(half_side);
        concave_.push_back(
            static_cast<float>(node(at).squared_distance - glm::dot(point, point) - rounding));
        triangles_.push_back(node(at).triangle);
      }
    }
  }
  for (at.z = 0; at.z < cells; ++at.z) {
    for (at.y = 0; at.y < cells; ++at.y) {
      for (at.x = 0; at.x < cells; ++at.x) {
        dvec3 moved(0.0);  // the most along an edge, in its direction
        for (int corner = 0; corner < 8; ++corner) {
          const glm::ivec3 from = at + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
          for (int axis = 0; axis < 3; ++axis) {
            glm::ivec3 to = from;
            to[axis] = at[axis] + 1;
            moved[axis] = std::max(moved[axis], node(to).closest[axis] - node(from).closest[axis]);
          }
        }
        const double gap = 0.5 * side * (moved.x + moved.y + moved.z);
        const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(gap + 3.0 * rounding));
        gap_.push_back(static_cast<std::uint16_t>((bits + 0xffff) >> 16));
      }
    }
  }
}

}  // namespace collage
