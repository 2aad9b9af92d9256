#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/mesh.h"

namespace collage {

/// A closed line of straight sides; the last point joins the first.
using Contour = std::vector<dvec2>;

/// A region of the plane by its contours, which keep it to their left: outlines run
/// counter-clockwise, holes clockwise. No two contours cross or touch, and none crosses itself.
using Region = std::vector<Contour>;

/// Contours are drawn on a grid of this step, on which turns and areas are exact in double. It is
/// far finer than curves are drawn, and what is closer together becomes one point.
inline constexpr double grid_step = 1.0 / 16384.0;

/// The nearest point of the grid.
dvec2 on_grid(const dvec2& point);

/// The points that `contours` wind round other than zero times, as fonts mean their outlines.
/// Contours may cross and overlap, themselves and each other, and run either way. Parts that would
/// touch in a point are drawn apart by 1/1000. Points come out on the grid.
///
/// Nothing where the contours cross more often than outlines of letters do (20,000 times), which
/// bounds time and memory, or do not come to rest on the grid. Coordinates are below 1024.
/// Cost: O((n + k) log n) with k crossings.
std::optional<Region> united(const std::vector<Contour>& contours);

/// The region's triangles, counter-clockwise, by indices into its points, contour by contour. All
/// have an area, and each side of a contour is a side of exactly one. Nothing where the contours
/// are not those of a region after all. Cost: O(n log n).
std::optional<std::vector<uvec3>> triangulated(const Region& region);

/// Signed, positive where counter-clockwise.
double area(const Contour& contour);
/// Sum over all contours.
double area(const Region& region);

/// Contour by contour, as triangulated() counts them.
std::vector<dvec2> all_points(const Region& region);
std::size_t point_count(const Region& region);

}  // namespace collage
