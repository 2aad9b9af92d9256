#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/mesh_repair.h"
#include "geometry/polygon.h"
#include "geometry/sheets.h"
#include "geometry/topology.h"

namespace collage {
namespace {

/// An edge of a single triangle, run the other way than that triangle does once it agrees with its
/// sheet; `corner` is the triangle's at `from`.
struct RimEdge {
  std::uint32_t sheet;
  std::uint32_t from;
  std::uint32_t to;
  std::uint32_t triangle;
  int corner;
};

struct Hole {
  std::vector<RimEdge> rim;
  /// Triangles between the places where the edges of the rim begin.
  std::vector<std::array<int, 3>> lid;
};

class HoleCloser {
 public:
  explicit HoleCloser(Mesh& mesh) : mesh_(mesh), topology_(mesh), found_(find_sheets(mesh)) {}

  ClosedHoles run();

 private:
  void gather_rims();
  std::vector<Hole> holes_of(std::span<RimEdge> rim) const;
  bool cover(const Sheet& sheet, Hole& hole) const;
  bool goes_on(const Hole& hole, const std::array<int, 3>& triangle) const;
  void add_triangle(const Hole& hole, const std::array<int, 3>& triangle);
  void turn_normals();
  dvec3 place(const RimEdge& edge) const { return mesh_.corner(edge.triangle, edge.corner); }

  Mesh& mesh_;
  Topology topology_;
  Sheets found_;
  /// By sheet, then by `from`.
  std::vector<RimEdge> rims_;
  /// Sheets that holes alone keep open.
  std::vector<char> can_be_closed_;
};

void HoleCloser::gather_rims() {
  std::vector<std::uint32_t> sheet_of(mesh_.triangles.size());
  for (std::uint32_t s = 0; s < found_.sheets.size(); ++s) {
    can_be_closed_.push_back(found_.sheets[s].one_sided ? 0 : 1);
    for (const std::uint32_t t : found_.sheets[s].triangles) {
      sheet_of[t] = s;
    }
  }
  for (std::size_t i = 0; i < topology_.edge_count(); ++i) {
    const auto uses = topology_.edge(i);
    const auto runs_up = [&](const EdgeUse& use) {
      return use.forward == (found_.flipped[use.triangle] == 0);
    };
    if (uses.size() > 1) {
      const bool balanced = 2 * std::ranges::count_if(uses, runs_up) == std::ssize(uses);
      for (const EdgeUse& use : uses) {
        can_be_closed_[sheet_of[use.triangle]] &= balanced ? 1 : 0;
      }
      continue;
    }
    const EdgeUse& use = uses[0];
    RimEdge edge{sheet_of[use.triangle], use.low, use.high, use.triangle, 0};
    if (runs_up(use)) {
      std::swap(edge.from, edge.to);
    }
    const uvec3 corners = welded_triangle(mesh_, topology_, use.triangle);
    while (corners[edge.corner] != edge.from) {
      ++edge.corner;
    }
    rims_.push_back(edge);
  }
  std::ranges::sort(rims_, {}, [](const RimEdge& e) { return std::tuple(e.sheet, e.from); });
}

/// The holes that a sheet's rim runs round; nothing where two of them touch, or one itself.
std::vector<Hole> HoleCloser::holes_of(std::span<RimEdge> rim) const {
  const auto touch = [](const RimEdge& a, const RimEdge& b) { return a.from == b.from; };
  if (std::ranges::adjacent_find(rim, touch) != rim.end()) {
    return {};
  }
  std::vector<char> taken(rim.size(), 0);
  std::vector<Hole> holes;
  for (std::size_t first = 0; first < rim.size(); ++first) {
    if (taken[first] != 0) {
      continue;
    }
    Hole& hole = holes.emplace_back();
    for (std::size_t next = first; taken[next] == 0;) {
      taken[next] = 1;
      hole.rim.push_back(rim[next]);
      const auto after = std::ranges::lower_bound(rim, rim[next].to, {}, &RimEdge::from);
      next = static_cast<std::size_t>(after - rim.begin());
    }
  }
  return holes;
}

/// Makes a lid for a hole that is small; else false.
bool HoleCloser::cover(const Sheet& sheet, Hole& hole) const {
  if (hole.rim.size() > largest_hole_edges) {
    return false;
  }
  std::vector<dvec3> corners;
  Box box;
  for (const RimEdge& edge : hole.rim) {
    corners.push_back(place(edge));
    box.include(corners.back());
  }
  if (box.longest_side() > widest_hole_share * sheet.box.longest_side()) {
    return false;
  }
  hole.lid = triangulate(corners);
  return std::ranges::all_of(hole.lid, [&](const auto& t) { return goes_on(hole, t); });
}

/// Whether a triangle of a lid has an area, and bends little against those across the rim.
bool HoleCloser::goes_on(const Hole& hole, const std::array<int, 3>& triangle) const {
  const auto& [a, b, c] = triangle;
  const dvec3 area =
      glm::cross(place(hole.rim[b]) - place(hole.rim[a]), place(hole.rim[c]) - place(hole.rim[a]));
  const double least = std::cos(glm::radians(sharpest_lid_degrees)) * glm::length(area);
  for (int k = 0; k < 3; ++k) {
    const RimEdge& edge = hole.rim[triangle[k]];
    if (edge.to != hole.rim[triangle[(k + 1) % 3]].from) {
      continue;
    }
    const auto [p, q, r] = oriented_corners(mesh_, found_.flipped, edge.triangle);
    const dvec3 beyond = glm::cross(q - p, r - p);
    if (glm::dot(area, beyond) < least * glm::length(beyond)) {
      return false;
    }
  }
  return area != dvec3(0.0);
}

void HoleCloser::add_triangle(const Hole& hole, const std::array<int, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  for (auto* indices : {&mesh_.triangles, &mesh_.uv_triangles, &mesh_.normal_triangles}) {
    if (!indices->empty()) {
      const auto index = [&](const RimEdge& edge) {
        return (*indices)[edge.triangle][edge.corner];
      };
      const uvec3 added(index(hole.rim[a]), index(hole.rim[b]), index(hole.rim[c]));
      indices->push_back(added);
    }
  }
  if (!mesh_.triangle_materials.empty()) {
    mesh_.triangle_materials.push_back(mesh_.triangle_materials[hole.rim[a].triangle]);
  }
  if (!mesh_.normal_triangles.empty()) {
    turn_normals();
  }
}

/// Gives the last triangle its own normal at corners where the one from beside it points inwards.
void HoleCloser::turn_normals() {
  const std::size_t last = mesh_.triangles.size() - 1;
  const dvec3 a = mesh_.corner(last, 0);
  const dvec3 area = glm::cross(mesh_.corner(last, 1) - a, mesh_.corner(last, 2) - a);
  for (int k = 0; k < 3; ++k) {
    std::uint32_t& index = mesh_.normal_triangles[last][k];
    if (glm::dot(mesh_.normals[index], area) <= 0) {
      index = static_cast<std::uint32_t>(mesh_.normals.size());
      mesh_.normals.push_back(glm::normalize(area));
    }
  }
}

ClosedHoles HoleCloser::run() {
  gather_rims();
  ClosedHoles closed;
  for (auto first = rims_.begin(); first != rims_.end();) {
    const std::uint32_t index = first->sheet;
    const auto end =
        std::find_if(first, rims_.end(), [&](const RimEdge& e) { return e.sheet != index; });
    std::vector<Hole> holes;
    if (can_be_closed_[index] != 0) {
      holes = holes_of({first, end});
    }
    const Sheet& sheet = found_.sheets[index];
    if (std::ranges::all_of(holes, [&](Hole& hole) { return cover(sheet, hole); })) {
      for (const Hole& hole : holes) {
        ++closed.holes;
        closed.triangles += hole.lid.size();
        for (const auto& triangle : hole.lid) {
          add_triangle(hole, triangle);
        }
      }
    }
    first = end;
  }
  return closed;
}

}  // namespace

ClosedHoles close_holes(Mesh& mesh) {
  return Topology(mesh).boundary_edge_count() > 0 ? HoleCloser(mesh).run() : ClosedHoles();
}

}  // namespace collage
