#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace collage {

/// One side of a triangle: between the welded vertices `low` < `high`, run from low to high where
/// `forward`.
struct EdgeUse {
  std::uint32_t low;
  std::uint32_t high;
  std::uint32_t triangle;
  bool forward;
};

/// Which triangles meet at which edges, once vertices at the same place are taken for one.
/// Triangles with two corners at the same place have no edges. Independent of the order in which
/// vertices are stored. Cost: O(n log n).
class Topology {
 public:
  explicit Topology(const Mesh& mesh);

  /// Of each vertex the first one at its place.
  [[nodiscard]] const std::vector<std::uint32_t>& welded() const { return welded_; }
  [[nodiscard]] std::size_t edge_count() const { return starts_.size() - 1; }
  /// Edges of one triangle.
  [[nodiscard]] std::size_t boundary_edge_count() const;
  /// The sides that meet at an edge, by rising triangle.
  [[nodiscard]] std::span<const EdgeUse> edge(std::size_t index) const {
    return std::span(uses_).subspan(starts_[index], starts_[index + 1] - starts_[index]);
  }

 private:
  std::vector<std::uint32_t> welded_;
  std::vector<EdgeUse> uses_;
  std::vector<std::size_t> starts_;
};

/// Sets of numbers 0 … n-1 that can be united; a set goes by its smallest member.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n);
  void unite(std::uint32_t a, std::uint32_t b);
  std::uint32_t find(std::uint32_t a);

 private:
  std::vector<std::uint32_t> parent_;
};

/// A triangle's corners in its mesh's welded vertices.
inline uvec3 welded_triangle(const Mesh& mesh, const Topology& topology, std::size_t triangle) {
  const uvec3& t = mesh.triangles[triangle];
  const auto& welded = topology.welded();
  return {welded[t.x], welded[t.y], welded[t.z]};
}

/// Of each triangle the number of its part, from 0 on in the order of their first triangles: parts
/// hang together by vertices at the same place. Cost: O(n log n).
std::vector<std::uint32_t> parts_by_vertices(const Mesh& mesh);

/// True where every edge is run as often one way as the other: the winding number is whole
/// everywhere off the surface and changes only across it. Cost: O(n log n).
bool is_closed(const Mesh& mesh);

inline bool has_two_equal(const uvec3& t) { return t.x == t.y || t.y == t.z || t.z == t.x; }

}  // namespace collage
