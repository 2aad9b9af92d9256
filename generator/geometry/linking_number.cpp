#include "geometry/linking_number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <queue>

#include "geometry/topology.h"

namespace collage {
namespace {

constexpr std::uint32_t nothing = ~0U;

/// The signed solid angle under which two segments see each other.
double solid_angle(const dvec3& p1, const dvec3& p2, const dvec3& q1, const dvec3& q2) {
  const dvec3 corners[4] = {q1 - p1, q2 - p1, q2 - p2, q1 - p2};
  dvec3 normals[4];
  for (int i = 0; i < 4; ++i) {
    const dvec3 normal = glm::cross(corners[i], corners[(i + 1) % 4]);
    const double length = glm::length(normal);
    if (!(length > 0.0)) {
      return 0.0;  // in one plane
    }
    normals[i] = normal / length;
  }
  double angle = 0.0;
  for (int i = 0; i < 4; ++i) {
    angle += std::asin(glm::clamp(glm::dot(normals[i], normals[(i + 1) % 4]), -1.0, 1.0));
  }
  return std::copysign(angle, glm::dot(glm::cross(q2 - q1, p2 - p1), corners[0]));
}

/// Crossings of two loops, seen along z after a shear along which no edge of a usual mesh lies, and
/// from the first point of the first.
class Crossings {
 public:
  Crossings(std::span<const dvec3> a, std::span<const dvec3> b) : a_(a), b_(b) {
    for (const auto& loop : {a, b}) {
      for (const dvec3& point : loop) {
        const dvec3 seen = glm::abs(this->seen(point));
        extent_ = std::max({extent_, seen.x, seen.y, seen.z});
      }
    }
  }

  /// Nothing where rounding may have decided.
  std::optional<int> count();

 private:
  struct Piece {
    dvec3 from;
    dvec3 to;
  };
  static constexpr std::size_t at_once = 64;

  [[nodiscard]] dvec3 seen(const dvec3& point) const {
    const dvec3 p = point - a_[0];
    return {p.x + 0.37139 * p.z, p.y + 0.23171 * p.z, p.z};
  }
  /// Twice the signed area of a triangle in the picture.
  static double area(const dvec3& p, const dvec3& q, const dvec3& r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  }
  [[nodiscard]] bool is_certain(double area) const {
    return std::abs(area) > tolerance * extent_ * extent_;
  }
  static bool boxes_meet(const Piece& p, const Piece& q) {
    return std::max(q.from.y, q.to.y) >= std::min(p.from.y, p.to.y) &&
           std::min(q.from.y, q.to.y) <= std::max(p.from.y, p.to.y) &&
           std::max(q.from.x, q.to.x) >= std::min(p.from.x, p.to.x) &&
           std::min(q.from.x, q.to.x) <= std::max(p.from.x, p.to.x);
  }
  void add(const Piece& p, const Piece& q);

  /// Far above what rounding does to an area of points within a square of side 2.
  static constexpr double tolerance = 1e-12;

  std::span<const dvec3> a_;
  std::span<const dvec3> b_;
  double extent_ = 0.0;
  int sum_ = 0;
  bool certain_ = true;
};

std::optional<int> Crossings::count() {
  for (std::size_t first = 0; first < b_.size(); first += at_once) {
    const std::size_t count = std::min(at_once, b_.size() - first);
    std::array<dvec3, at_once + 1> of_b;
    for (std::size_t j = 0; j <= count; ++j) {
      of_b[j] = seen(b_[(first + j) % b_.size()]);
    }
    Piece p{{}, seen(a_[0])};
    for (std::size_t i = 1; i <= a_.size(); ++i) {
      p = {p.to, seen(a_[i % a_.size()])};
      for (std::size_t j = 0; j < count; ++j) {
        const Piece q{of_b[j], of_b[j + 1]};
        if (boxes_meet(p, q)) {
          add(p, q);
        }
      }
    }
  }
  return certain_ ? std::optional(sum_) : std::nullopt;
}

void Crossings::add(const Piece& p, const Piece& q) {
  const double p_from = area(q.from, q.to, p.from);
  const double p_to = area(q.from, q.to, p.to);
  const double q_from = area(p.from, p.to, q.from);
  const double q_to = area(p.from, p.to, q.to);
  if (!is_certain(p_from) || !is_certain(p_to) || !is_certain(q_from) || !is_certain(q_to)) {
    certain_ = false;
    return;
  }
  if ((p_from > 0.0) == (p_to > 0.0) || (q_from > 0.0) == (q_to > 0.0)) {
    return;
  }
  const double p_span = p_from - p_to;
  const double q_span = q_from - q_to;
  const double p_depth = p.from.z + p_from / p_span * (p.to.z - p.from.z);
  const double q_depth = q.from.z + q_from / q_span * (q.to.z - q.from.z);
  const double error =
      tolerance * extent_ * extent_ * extent_ / std::min(std::abs(p_span), std::abs(q_span));
  certain_ = certain_ && std::abs(p_depth - q_depth) > error;
  if (p_depth > q_depth) {
    sum_ += p_to > 0.0 ? -1 : 1;
  }
}

class LoopFinder {
 public:
  explicit LoopFinder(const Mesh& mesh)
      : mesh_(mesh),
        topology_(mesh),
        distance_(mesh.positions.size(), std::numeric_limits<double>::infinity()),
        parent_(mesh.positions.size(), nothing),
        spokes_(mesh.positions.size()) {}

  std::vector<Loop> run();

 private:
  struct Edge {
    std::uint32_t low;
    std::uint32_t high;
    std::uint32_t left;
    std::uint32_t right;
  };

  void gather_edges();
  void walk_from(std::uint32_t root);
  [[nodiscard]] double length(std::uint32_t a, std::uint32_t b) const {
    return glm::distance(mesh_.positions[a], mesh_.positions[b]);
  }
  [[nodiscard]] bool in_tree(const Edge& edge) const {
    return parent_[edge.low] == edge.high || parent_[edge.high] == edge.low;
  }
  [[nodiscard]] Loop loop_through(const Edge& edge) const;

  const Mesh& mesh_;
  Topology topology_;
  std::vector<Edge> edges_;
  std::vector<double> distance_;
  std::vector<std::uint32_t> parent_;
  std::vector<std::vector<std::uint32_t>> spokes_;
};

/// Edges of parts that are two-manifold along all of them.
void LoopFinder::gather_edges() {
  DisjointSets parts(mesh_.positions.size());
  for (std::size_t e = 0; e < topology_.edge_count(); ++e) {
    parts.unite(topology_.edge(e)[0].low, topology_.edge(e)[0].high);
  }
  std::vector<char> refused(mesh_.positions.size(), 0);
  for (std::size_t e = 0; e < topology_.edge_count(); ++e) {
    if (topology_.edge(e).size() != 2) {
      refused[parts.find(topology_.edge(e)[0].low)] = 1;
    }
  }
  for (std::size_t e = 0; e < topology_.edge_count(); ++e) {
    const auto uses = topology_.edge(e);
    if (refused[parts.find(uses[0].low)] == 0) {
      edges_.push_back({uses[0].low, uses[0].high, uses[0].triangle, uses[1].triangle});
      spokes_[uses[0].low].push_back(uses[0].high);
      spokes_[uses[0].high].push_back(uses[0].low);
    }
  }
}

/// Shortest paths along edges (Dijkstra 1959).
void LoopFinder::walk_from(std::uint32_t root) {
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  distance_[root] = 0.0;
  queue.emplace(0.0, root);
  while (!queue.empty()) {
    const auto [distance, vertex] = queue.top();
    queue.pop();
    if (distance > distance_[vertex]) {
      continue;
    }
    for (const std::uint32_t next : spokes_[vertex]) {
      const double way = distance + length(vertex, next);
      if (way < distance_[next]) {
        distance_[next] = way;
        parent_[next] = vertex;
        queue.emplace(way, next);
      }
    }
  }
}

/// From where the paths to both ends part, along one, over the edge and back along the other.
Loop LoopFinder::loop_through(const Edge& edge) const {
  const auto path = [&](std::uint32_t vertex) {
    std::vector<std::uint32_t> to_root{vertex};
    while (parent_[vertex] != nothing) {
      vertex = parent_[vertex];
      to_root.push_back(vertex);
    }
    return to_root;
  };
  std::vector<std::uint32_t> there = path(edge.low);
  std::vector<std::uint32_t> back = path(edge.high);
  while (there.size() > 1 && back.size() > 1 && there[there.size() - 2] == back[back.size() - 2]) {
    there.pop_back();
    back.pop_back();
  }
  back.pop_back();
  Loop loop;
  for (auto vertex = there.rbegin(); vertex != there.rend(); ++vertex) {
    loop.push_back(mesh_.positions[*vertex]);
  }
  for (const std::uint32_t vertex : back) {
    loop.push_back(mesh_.positions[vertex]);
  }
  return loop;
}

std::vector<Loop> LoopFinder::run() {
  gather_edges();
  for (const Edge& edge : edges_) {
    if (distance_[edge.low] == std::numeric_limits<double>::infinity()) {
      walk_from(edge.low);
    }
  }
  std::erase_if(edges_, [&](const Edge& edge) { return in_tree(edge); });
  const auto way_round = [&](const Edge& edge) {
    return distance_[edge.low] + distance_[edge.high] + length(edge.low, edge.high);
  };
  std::ranges::stable_sort(
      edges_, [&](const Edge& a, const Edge& b) { return way_round(a) > way_round(b); });
  DisjointSets triangles(mesh_.triangles.size());
  std::vector<Loop> loops;
  for (const Edge& edge : edges_) {
    if (triangles.find(edge.left) != triangles.find(edge.right)) {
      triangles.unite(edge.left, edge.right);
    } else {
      loops.push_back(loop_through(edge));
    }
  }
  return loops;
}

}  // namespace

int linking_number(std::span<const dvec3> a, std::span<const dvec3> b) {
  if (a.empty() || b.empty()) {
    return 0;
  }
  const std::optional<int> count = Crossings(a, b).count();
  return count ? *count : linking_number_by_solid_angles(a, b);
}

int linking_number_by_solid_angles(std::span<const dvec3> a, std::span<const dvec3> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      sum += solid_angle(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()]);
    }
  }
  return static_cast<int>(std::lround(sum / (4.0 * std::numbers::pi)));
}

std::vector<Loop> handle_loops(const Mesh& mesh) { return LoopFinder(mesh).run(); }

}  // namespace collage
