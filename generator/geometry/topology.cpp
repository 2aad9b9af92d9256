#include "geometry/topology.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace collage {
namespace {

std::vector<std::uint32_t> weld(const std::vector<dvec3>& positions) {
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::uint32_t i) {
    const dvec3& p = positions[i];
    return std::tuple(p.x, p.y, p.z, i);
  };
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  std::vector<std::uint32_t> first(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && positions[order[i]] == positions[order[i - 1]];
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  return first;
}

}  // namespace

Topology::Topology(const Mesh& mesh) : welded_(weld(mesh.positions)) {
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const uvec3 corners = welded_triangle(mesh, *this, t);
    if (has_two_equal(corners)) {
      continue;
    }
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t from = corners[k];
      const std::uint32_t to = corners[(k + 1) % 3];
      uses_.push_back({std::min(from, to), std::max(from, to), t, from < to});
    }
  }
  std::sort(uses_.begin(), uses_.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  for (std::size_t i = 0; i < uses_.size(); ++i) {
    const bool same =
        i > 0 && uses_[i].low == uses_[i - 1].low && uses_[i].high == uses_[i - 1].high;
    if (!same) {
      starts_.push_back(i);
    }
  }
  starts_.push_back(uses_.size());
}

std::size_t Topology::boundary_edge_count() const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < edge_count(); ++i) {
    count += edge(i).size() == 1 ? 1 : 0;
  }
  return count;
}

DisjointSets::DisjointSets(std::size_t n) : parent_(n) {
  std::iota(parent_.begin(), parent_.end(), 0U);
}

std::uint32_t DisjointSets::find(std::uint32_t a) {
  while (parent_[a] != a) {
    parent_[a] = parent_[parent_[a]];
    a = parent_[a];
  }
  return a;
}

void DisjointSets::unite(std::uint32_t a, std::uint32_t b) {
  a = find(a);
  b = find(b);
  parent_[std::max(a, b)] = std::min(a, b);
}

std::vector<std::uint32_t> parts_by_vertices(const Mesh& mesh) {
  const Topology topology(mesh);
  DisjointSets sets(mesh.positions.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const uvec3 corners = welded_triangle(mesh, topology, t);
    sets.unite(corners.x, corners.y);
    sets.unite(corners.y, corners.z);
  }
  constexpr auto unnumbered = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(mesh.positions.size(), unnumbered);
  std::vector<std::uint32_t> parts;
  parts.reserve(mesh.triangles.size());
  std::uint32_t count = 0;
  for (const uvec3& t : mesh.triangles) {
    std::uint32_t& part = number[sets.find(topology.welded()[t.x])];
    part = part == unnumbered ? count++ : part;
    parts.push_back(part);
  }
  return parts;
}

bool is_closed(const Mesh& mesh) {
  const Topology topology(mesh);
  for (std::size_t e = 0; e < topology.edge_count(); ++e) {
    const auto uses = topology.edge(e);
    if (2 * std::ranges::count_if(uses, &EdgeUse::forward) != std::ssize(uses)) {
      return false;
    }
  }
  return true;
}

}  // namespace collage
