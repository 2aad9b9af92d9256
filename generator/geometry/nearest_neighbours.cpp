#include "geometry/nearest_neighbours.h"

#include <cassert>
#include <cmath>
#include <limits>

#include <tbb/parallel_for.h>

#include "geometry/box_tree_search.h"
#include "geometry/boxes.h"

namespace collage {
namespace {

std::uint32_t nearest_neighbour(const BoxTree& tree, const dvec3& point, std::uint32_t self) {
  constexpr double unbounded = std::numeric_limits<double>::infinity();
  double best = unbounded;
  std::uint32_t nearest = 0;
  visit_lowest_first(
      tree, [&](const Box& box) { return squared_distance(box, point); }, unbounded,
      [&](const BoxTree::Node& leaf) {
        const double squared = squared_distance(leaf.box, point);
        if (leaf.item != self && (squared < best || (squared == best && leaf.item < nearest))) {
          best = squared;
          nearest = leaf.item;
        }
        return std::nextafter(best, unbounded);  // others as near are looked at, too
      });
  return nearest;
}

}  // namespace

std::vector<std::uint32_t> nearest_neighbours(std::span<const dvec3> points) {
  assert(points.size() > 1);
  const BoxTree tree(boxes_of_points(points));
  std::vector<std::uint32_t> nearest(points.size());
  tbb::parallel_for(std::uint32_t{0}, static_cast<std::uint32_t>(points.size()),
                    [&](std::uint32_t i) { nearest[i] = nearest_neighbour(tree, points[i], i); });
  return nearest;
}

}  // namespace collage
