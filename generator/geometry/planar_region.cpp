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

/// Whether the line goes straight back at the middle one of three points.
bool turns_back(const dvec2& before, const dvec2& point, const dvec2& behind) {
  return glm::dot(before - point, behind - point) > 0.0 && orient2d(before, point, behind) == 0;
}

/// On the grid, no point twice in a row, and without spikes.
Contour tidied(const Contour& contour) {
  Contour kept;
  for (const dvec2& exact : contour) {
    const dvec2 point = on_grid(exact);
    while (kept.size() >= 2 && turns_back(kept.end()[-2], kept.back(), point)) {
      kept.pop_back();
    }
    if (kept.empty() || kept.back() != point) {
      kept.push_back(point);
    }
  }
  auto first = kept.begin();  // now the same across the seam
  for (bool idle = true; idle && kept.end() - first >= 3;) {
    idle = true;
    if (kept.back() == *first || turns_back(kept.end()[-2], kept.back(), *first)) {
      kept.pop_back();
    } else if (turns_back(kept.back(), *first, first[1])) {
      ++first;
    } else {
      idle = false;
    }
  }
  return {first, kept.end()};
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

std::vector<dvec2> all_points(const Region& region) {
  std::vector<dvec2> points;
  for (const Contour& contour : region) {
    points.insert(points.end(), contour.begin(), contour.end());
  }
  return points;
}

std::size_t point_count(const Region& region) {
  return std::accumulate(
      region.begin(), region.end(), std::size_t{0},
      [](std::size_t sum, const Contour& contour) { return sum + contour.size(); });
}

}  // namespace collage
