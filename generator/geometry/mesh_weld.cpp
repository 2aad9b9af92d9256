#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>
#include <utility>
#include <vector>

#include "geometry/mesh_repair.h"
#include "geometry/topology.h"

namespace collage {
namespace {

/// Points that are farther than `tolerance` from each other, by cells of that side.
class SparsePoints {
 public:
  SparsePoints(const std::vector<dvec3>& positions, const dvec3& origin, double tolerance)
      : positions_(positions), origin_(origin), tolerance_(tolerance) {}

  /// The lowest of the points within reach of a position; itself, which is added, where there is
  /// none.
  std::uint32_t first_near(std::uint32_t index);

 private:
  static std::uint64_t key(const glm::i64vec3& cell) {
    constexpr int bits = 21;  // the box has 1 / weld_share cells on a side, far fewer than 2^21
    const glm::u64vec3 c(cell + std::int64_t{1});
    return c.x << 2 * bits | c.y << bits | c.z;
  }

  const std::vector<dvec3>& positions_;
  dvec3 origin_;
  double tolerance_;
  std::unordered_multimap<std::uint64_t, std::uint32_t> points_;
};

std::uint32_t SparsePoints::first_near(std::uint32_t index) {
  const dvec3& position = positions_[index];
  const glm::i64vec3 cell(glm::floor((position - origin_) / tolerance_));
  std::uint32_t first = index;
  for (int neighbor = 0; neighbor < 27; ++neighbor) {
    const glm::i64vec3 step(neighbor % 3 - 1, neighbor / 3 % 3 - 1, neighbor / 9 - 1);
    const auto [begin, end] = points_.equal_range(key(cell + step));
    for (auto point = begin; point != end; ++point) {
      if (point->second < first &&
          glm::distance(positions_[point->second], position) <= tolerance_) {
        first = point->second;
      }
    }
  }
  if (first == index) {
    points_.emplace(key(cell), index);
  }
  return first;
}

std::vector<char> boundary_vertices(const Topology& topology) {
  std::vector<char> found(topology.welded().size(), 0);
  for (std::size_t i = 0; i < topology.edge_count(); ++i) {
    if (const auto edge = topology.edge(i); edge.size() == 1) {
      found[edge[0].low] = found[edge[0].high] = 1;
    }
  }
  return found;
}

/// Where each of the vertices at different places goes.
std::vector<std::uint32_t> find_moves(const Mesh& mesh, const Topology& topology) {
  const std::vector<char> at_boundary = boundary_vertices(topology);
  const Box box = bounding_box(mesh);
  SparsePoints points(mesh.positions, box.min, weld_share * box.longest_side());
  std::vector<std::uint32_t> place(mesh.positions.size());
  std::iota(place.begin(), place.end(), 0U);
  for (std::uint32_t v = 0; v < place.size(); ++v) {
    if (at_boundary[v] != 0) {
      place[v] = points.first_near(v);
    }
  }
  return place;
}

/// Takes back moves that leave a triangle without area, and the others of its corners; each of
/// which may leave others of its triangles without.
void keep_areas(const Mesh& mesh, const Topology& topology, std::vector<std::uint32_t>& place) {
  const auto moved = [&](const uvec3& t) { return uvec3(place[t.x], place[t.y], place[t.z]); };
  std::vector<std::size_t> to_check;
  std::vector<std::pair<std::uint32_t, std::size_t>> triangles;  // by corner
  for (std::size_t t = mesh.triangles.size(); t-- > 0;) {
    const uvec3 corners = welded_triangle(mesh, topology, t);
    if (moved(corners) != corners) {
      to_check.push_back(t);
      for (int k = 0; k < 3; ++k) {
        triangles.emplace_back(corners[k], t);
      }
    }
  }
  std::ranges::sort(triangles);
  while (!to_check.empty()) {
    const uvec3 from = welded_triangle(mesh, topology, to_check.back());
    to_check.pop_back();
    const uvec3 to = moved(from);
    const dvec3 a = mesh.positions[to.x];
    if (from == to ||
        glm::cross(mesh.positions[to.y] - a, mesh.positions[to.z] - a) != dvec3(0.0)) {
      continue;
    }
    for (int k = 0; k < 3; ++k) {
      if (std::exchange(place[from[k]], from[k]) != from[k]) {
        const auto first = std::ranges::lower_bound(triangles, std::pair(from[k], std::size_t{0}));
        for (auto next = first; next != triangles.end() && next->first == from[k]; ++next) {
          to_check.push_back(next->second);
        }
      }
    }
  }
}

}  // namespace

std::size_t weld(Mesh& mesh) {
  const Topology topology(mesh);
  const std::size_t edges = topology.boundary_edge_count();
  if (edges == 0) {
    return 0;
  }
  std::vector<std::uint32_t> place = find_moves(mesh, topology);
  keep_areas(mesh, topology, place);
  std::vector<dvec3> moved = mesh.positions;
  std::size_t moves = 0;
  for (std::uint32_t v = 0; v < moved.size(); ++v) {
    const std::uint32_t to = place[topology.welded()[v]];
    moved[v] = mesh.positions[to];
    moves += place[v] != v ? 1 : 0;
  }
  if (moves == 0) {
    return 0;
  }
  std::swap(mesh.positions, moved);
  if (Topology(mesh).boundary_edge_count() >= edges) {
    std::swap(mesh.positions, moved);
    return 0;
  }
  return moves;
}

}  // namespace collage
