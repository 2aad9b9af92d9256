#include "geometry/planar_region.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "geometry/glu_tessellator.h"
#include "geometry/predicates.h"

namespace collage {
namespace {

/// How far corners that touch are drawn back, each into its own part.
constexpr double half_gap = 1.0 / 2048.0;
constexpr double smallest_area = 4.0 * grid_step * grid_step;
constexpr int most_rounds = 12;
constexpr std::size_t most_crossings = 20000;
constexpr std::size_t most_comparisons = 100'000'000;

using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::vector<dvec2> all_points(const Region& region) {
  std::vector<dvec2> points;
  for (const Contour& contour : region) {
    points.insert(points.end(), contour.begin(), contour.end());
  }
  return points;
}

/// Whether the line turns back at the middle one of three points, or does not move.
bool is_idle(const dvec2& before, const dvec2& point, const dvec2& behind) {
  return before == point ||
         (glm::dot(before - point, behind - point) > 0.0 && orient2d(before, point, behind) == 0);
}

/// On the grid, no point twice in a row, and without spikes.
Contour tidied(const Contour& contour) {
  std::vector<dvec2> points;
  for (const dvec2& point : contour) {
    points.push_back(on_grid(point));
  }
  for (std::size_t size = 0; size != points.size();) {
    size = points.size();
    Contour kept;
    for (std::size_t i = 0; i < size; ++i) {
      const dvec2& before = kept.empty() ? points.back() : kept.back();
      if (!is_idle(before, points[i], points[(i + 1) % size])) {
        kept.push_back(points[i]);
      }
    }
    points = std::move(kept);
  }
  return points;
}

/// The same of all; what has less than three points is left out.
Region tidied(const std::vector<Contour>& contours) {
  Region result;
  for (const Contour& contour : contours) {
    Contour tidy = tidied(contour);
    if (tidy.size() >= 3) {
      result.push_back(std::move(tidy));
    }
  }
  return result;
}

struct Side {
  dvec2 from;
  dvec2 to;
  [[nodiscard]] double left() const { return std::min(from.x, to.x); }
  [[nodiscard]] double right() const { return std::max(from.x, to.x); }
};

bool cross(const Side& s, const Side& t) {
  const auto [s_low, s_high] = std::minmax(s.from.y, s.to.y);
  const auto [t_low, t_high] = std::minmax(t.from.y, t.to.y);
  return s_low <= t_high && t_low <= s_high && s.from != t.to && s.to != t.from &&
         orient2d(s.from, s.to, t.from) * orient2d(s.from, s.to, t.to) <= 0 &&
         orient2d(t.from, t.to, s.from) * orient2d(t.from, t.to, s.to) <= 0;
}

/// Whether the sides cross no more often than letters' do, found without more work than that takes.
bool is_tame(const std::vector<Contour>& contours) {
  std::vector<Side> sides;
  for (const Contour& contour : contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      sides.push_back({contour[i], contour[(i + 1) % contour.size()]});
    }
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return a.left() < b.left(); });
  std::vector<Side> active;
  std::size_t comparisons = 0;
  std::size_t crossings = 0;
  for (const Side& side : sides) {
    std::erase_if(active, [&](const Side& other) { return other.right() < side.left(); });
    comparisons += active.size();
    if (comparisons > most_comparisons) {
      return false;
    }
    crossings += static_cast<std::size_t>(std::count_if(
        active.begin(), active.end(), [&](const Side& other) { return cross(side, other); }));
    if (crossings > most_crossings) {
      return false;
    }
    active.push_back(side);
  }
  return true;
}

/// What GLU found of the region, without the smallest parts and holes.
Region boundary(const std::vector<Contour>& region, const Tessellation& tessellation) {
  std::vector<dvec2> points = all_points(region);
  points.insert(points.end(), tessellation.added.begin(), tessellation.added.end());
  Region result;
  for (const auto& loop : tessellation.primitives) {
    Contour contour;
    for (const std::uint32_t index : loop) {
      contour.push_back(points.at(index));
    }
    if (std::abs(area(contour)) >= smallest_area) {
      result.push_back(std::move(contour));
    }
  }
  return result;
}

/// The direction halfway between the two sides at a corner, into the region.
dvec2 inward(const Contour& contour, std::size_t corner) {
  const std::size_t n = contour.size();
  const dvec2 before = glm::normalize(contour[corner] - contour[(corner + n - 1) % n]);
  const dvec2 behind = glm::normalize(contour[(corner + 1) % n] - contour[corner]);
  const dvec2 along = before + behind;
  const double length = glm::length(along);
  return length > 1e-9 ? dvec2(-along.y, along.x) / length : -before;
}

/// Draws corners at the same place back into their parts.
Region drawn_apart(const Region& region) {
  std::map<std::pair<double, double>, int> count;
  for (const Contour& contour : region) {
    for (const dvec2& point : contour) {
      ++count[{point.x, point.y}];
    }
  }
  Region result = region;
  for (std::size_t c = 0; c < region.size(); ++c) {
    for (std::size_t i = 0; i < region[c].size(); ++i) {
      const dvec2& point = region[c][i];
      if (count.at({point.x, point.y}) > 1) {
        result[c][i] = on_grid(point + half_gap * inward(region[c], i));
      }
    }
  }
  return result;
}

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

dvec2 on_grid(const dvec2& point) { return glm::round(point / grid_step) * grid_step; }

std::optional<Region> united(const std::vector<Contour>& contours) {
  Region region = tidied(contours);
  for (int round = 0; round < most_rounds; ++round) {
    if (!is_tame(region)) {
      return std::nullopt;
    }
    const Tessellation tessellation = boundary_by_glu(region);
    if (tessellation.failed) {
      return std::nullopt;
    }
    const Region found = boundary(region, tessellation);
    region = drawn_apart(tidied(found));
    if (tessellation.added.empty() && region == found) {
      return region;
    }
  }
  return std::nullopt;
}

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

double area(const Contour& contour) {
  double twice = 0.0;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const dvec2 a = contour[i] - contour[0];
    const dvec2 b = contour[(i + 1) % contour.size()] - contour[0];
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * twice;
}

double area(const Region& region) {
  return std::accumulate(region.begin(), region.end(), 0.0,
                         [](double sum, const Contour& contour) { return sum + area(contour); });
}

std::size_t point_count(const Region& region) {
  return std::accumulate(
      region.begin(), region.end(), std::size_t{0},
      [](std::size_t sum, const Contour& contour) { return sum + contour.size(); });
}

}  // namespace collage
