#include <algorithm>
#include <map>
#include <utility>

#include "geometry/glu_tessellator.h"
#include "geometry/planar_region.h"
#include "geometry/predicates.h"

namespace collage {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// Triangles by their sides.
class Patch {
 public:
  explicit Patch(const std::vector<std::uint32_t>& corners, const std::vector<dvec2>& points)
      : points_(points) {
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
      triangles_.emplace_back(corners[i], corners[i + 1], corners[i + 2]);
      enter(static_cast<std::uint32_t>(triangles_.size() - 1));
    }
  }

  /// Exchanges the common side of a triangle without area and its neighbour, until all have an
  /// area; false where that cannot be.
  bool mend_flat_triangles() {
    std::vector<std::uint32_t> flat;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      if (turn(triangles_[t]) == 0) {
        flat.push_back(t);
      }
    }
    for (bool mended = true; mended;) {
      mended = std::erase_if(flat, [&](std::uint32_t t) { return mend(t); }) > 0;
    }
    return flat.empty() && std::all_of(triangles_.begin(), triangles_.end(),
                                       [&](const uvec3& t) { return turn(t) > 0; });
  }

  /// Each side of a contour is one triangle's side, all others are two triangles'.
  [[nodiscard]] bool fits(const Region& region) const {
    std::size_t inner = sides_.size();
    std::uint32_t first = 0;
    for (const Contour& contour : region) {
      const auto n = static_cast<std::uint32_t>(contour.size());
      for (std::uint32_t i = 0; i < n; ++i) {
        const Edge side{first + i, first + (i + 1) % n};
        if (!sides_.contains(side) || sides_.contains({side.second, side.first})) {
          return false;
        }
        --inner;
      }
      first += n;
    }
    const auto paired = std::count_if(sides_.begin(), sides_.end(), [&](const auto& entry) {
      return sides_.contains({entry.first.second, entry.first.first});
    });
    return !twice_ && static_cast<std::size_t>(paired) == inner;
  }

  [[nodiscard]] const std::vector<uvec3>& triangles() const { return triangles_; }

 private:
  [[nodiscard]] int turn(const uvec3& t) const {
    return orient2d(points_[t.x], points_[t.y], points_[t.z]);
  }

  void enter(std::uint32_t triangle) {
    const uvec3& t = triangles_[triangle];
    for (int k = 0; k < 3; ++k) {
      twice_ |= !sides_.try_emplace({t[k], t[(k + 1) % 3]}, triangle).second;
    }
  }
  void leave(std::uint32_t triangle) {
    const uvec3& t = triangles_[triangle];
    for (int k = 0; k < 3; ++k) {
      sides_.erase({t[k], t[(k + 1) % 3]});
    }
  }

  /// Of the flat triangle p, q, r with q in the middle and its neighbour p, r, s makes p, q, s and
  /// q, r, s.
  bool mend(std::uint32_t flat) {
    const uvec3 t = triangles_[flat];
    int k = 0;
    while (k < 3 && glm::dot(points_[t[k]] - points_[t[(k + 1) % 3]],
                             points_[t[(k + 2) % 3]] - points_[t[(k + 1) % 3]]) >= 0) {
      ++k;
    }
    if (k == 3) {
      return false;  // two corners at the same place
    }
    const std::uint32_t p = t[k];
    const std::uint32_t q = t[(k + 1) % 3];
    const std::uint32_t r = t[(k + 2) % 3];
    const auto found = sides_.find({p, r});
    if (found == sides_.end() || turn(triangles_[found->second]) <= 0) {
      return false;
    }
    const std::uint32_t neighbour = found->second;
    const uvec3 n = triangles_[neighbour];
    const std::uint32_t s = n.x ^ n.y ^ n.z ^ p ^ r;  // the corner that is neither p nor r
    leave(flat);
    leave(neighbour);
    triangles_[flat] = {p, q, s};
    triangles_[neighbour] = {q, r, s};
    enter(flat);
    enter(neighbour);
    return true;
  }

  const std::vector<dvec2>& points_;
  std::vector<uvec3> triangles_;
  std::map<Edge, std::uint32_t> sides_;
  bool twice_ = false;
};

}  // namespace

std::optional<std::vector<uvec3>> triangulated(const Region& region) {
  const Tessellation tessellation = triangles_by_glu(region);
  if (tessellation.failed || !tessellation.added.empty() || tessellation.primitives.size() > 1) {
    return std::nullopt;
  }
  const std::vector<dvec2> points = all_points(region);
  Patch patch(tessellation.primitives.empty() ? std::vector<std::uint32_t>{}
                                              : tessellation.primitives.front(),
              points);
  if (!patch.mend_flat_triangles() || !patch.fits(region)) {
    return std::nullopt;
  }
  return patch.triangles();
}

}  // namespace collage
