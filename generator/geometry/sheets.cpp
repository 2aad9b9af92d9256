#include "geometry/sheets.h"

#include <algorithm>
#include <map>
#include <utility>

namespace collage {
namespace {

constexpr std::uint32_t no_patch = ~0U;

/// Triangles that hang together by edges of two triangles.
struct Patch {
  std::vector<std::uint32_t> triangles;
  bool one_sided = false;
  bool has_rim = false;
};

class SheetFinder {
 public:
  explicit SheetFinder(const Mesh& mesh)
      : mesh_(mesh),
        topology_(mesh),
        links_(mesh.triangles.size()),
        patch_of_(links_.size(), no_patch),
        flipped_(links_.size()) {}

  Sheets run();

 private:
  /// A triangle across an edge of two triangles, and whether the two run that edge the same way.
  struct Link {
    std::uint32_t neighbor;
    bool against;
  };

  void link_triangles();
  void walk(std::uint32_t first);
  void side_with_most(const Patch& patch);
  DisjointSets join_patches();
  void measure(Sheet& sheet) const;

  const Mesh& mesh_;
  Topology topology_;
  std::vector<std::vector<Link>> links_;
  std::vector<Patch> patches_;
  std::vector<std::uint32_t> patch_of_;
  std::vector<char> flipped_;
};

void SheetFinder::link_triangles() {
  for (std::size_t i = 0; i < topology_.edge_count(); ++i) {
    const auto edge = topology_.edge(i);
    if (edge.size() == 2) {
      const bool against = edge[0].forward == edge[1].forward;
      links_[edge[0].triangle].push_back({edge[1].triangle, against});
      links_[edge[1].triangle].push_back({edge[0].triangle, against});
    }
  }
}

/// Gathers a patch, marking the triangles that disagree with the first.
void SheetFinder::walk(std::uint32_t first) {
  const auto index = static_cast<std::uint32_t>(patches_.size());
  Patch& patch = patches_.emplace_back();
  patch.triangles.push_back(first);
  patch_of_[first] = index;
  for (std::size_t i = 0; i < patch.triangles.size(); ++i) {
    const std::uint32_t t = patch.triangles[i];
    for (const Link& link : links_[t]) {
      const char wanted = flipped_[t] ^ static_cast<char>(link.against);
      if (patch_of_[link.neighbor] == no_patch) {
        patch_of_[link.neighbor] = index;
        flipped_[link.neighbor] = wanted;
        patch.triangles.push_back(link.neighbor);
      } else if (flipped_[link.neighbor] != wanted) {
        patch.one_sided = true;
      }
    }
  }
  side_with_most(patch);
}

/// Swaps the marks where most triangles have one; takes them off where they are of no use.
void SheetFinder::side_with_most(const Patch& patch) {
  const auto marked = std::count_if(patch.triangles.begin(), patch.triangles.end(),
                                    [&](std::uint32_t t) { return flipped_[t] != 0; });
  const bool most = 2 * marked > std::ssize(patch.triangles);
  for (const std::uint32_t t : patch.triangles) {
    flipped_[t] = patch.one_sided ? char{0} : static_cast<char>(flipped_[t] ^ char{most});
  }
}

/// Unites the patches that meet at an edge and balance each other there; where they do not balance,
/// and where there is only one, the edge is a rim. A patch in balance by itself only touches.
DisjointSets SheetFinder::join_patches() {
  DisjointSets groups(patches_.size());
  for (std::size_t i = 0; i < topology_.edge_count(); ++i) {
    std::map<std::uint32_t, int> balance;
    int total = 0;
    for (const EdgeUse& use : topology_.edge(i)) {
      const int way = use.forward == (flipped_[use.triangle] == 0) ? 1 : -1;
      balance[patch_of_[use.triangle]] += way;
      total += way;
    }
    std::erase_if(balance, [](const auto& entry) { return entry.second == 0; });
    for (const auto& [patch, own] : balance) {
      patches_[patch].has_rim = patches_[patch].has_rim || total != 0;
      if (total == 0) {
        groups.unite(balance.begin()->first, patch);
      }
    }
  }
  return groups;
}

void SheetFinder::measure(Sheet& sheet) const {
  dvec3 moment(0.0);
  const dvec3 origin = mesh_.corner(sheet.triangles[0], 0);
  for (const std::uint32_t t : sheet.triangles) {
    const auto [a, b, c] = oriented_corners(mesh_, flipped_, t);
    const double area = 0.5 * glm::length(glm::cross(b - a, c - a));
    sheet.area += area;
    moment += area / 3.0 * ((a - origin) + (b - origin) + (c - origin));
    for (const dvec3& corner : {a, b, c}) {
      sheet.box.include(corner);
    }
  }
  const dvec3 centroid = sheet.area > 0 ? origin + moment / sheet.area : origin;
  for (const std::uint32_t t : sheet.triangles) {
    const auto [a, b, c] = oriented_corners(mesh_, flipped_, t);
    sheet.volume += glm::dot(a - centroid, glm::cross(b - centroid, c - centroid)) / 6.0;
  }
}

Sheets SheetFinder::run() {
  link_triangles();
  for (std::uint32_t t = 0; t < links_.size(); ++t) {
    if (patch_of_[t] == no_patch && !has_two_equal(welded_triangle(mesh_, topology_, t))) {
      walk(t);
    }
  }
  DisjointSets groups = join_patches();
  std::map<std::uint32_t, Sheet> sheets;
  for (std::uint32_t p = 0; p < patches_.size(); ++p) {
    const Patch& patch = patches_[p];
    Sheet& sheet = sheets[groups.find(p)];
    sheet.triangles.insert(sheet.triangles.end(), patch.triangles.begin(), patch.triangles.end());
    sheet.closed = sheet.closed && !patch.has_rim;
    sheet.one_sided = sheet.one_sided || patch.one_sided;
  }
  Sheets result;
  for (auto& [group, sheet] : sheets) {
    measure(sheet);
    result.sheets.push_back(std::move(sheet));
  }
  result.flipped = std::move(flipped_);
  return result;
}

}  // namespace

Sheets find_sheets(const Mesh& mesh) { return SheetFinder(mesh).run(); }

}  // namespace collage
