#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include "geometry/mesh.h"

namespace collage {

inline bool boxes_meet(const Box& a, const Box& b) {
  return glm::all(glm::lessThanEqual(a.min, b.max)) && glm::all(glm::lessThanEqual(b.min, a.max));
}

/// A binary hierarchy of boxes, in double. Build O(n log n).
class BoxTree {
 public:
  struct Node {
    Box box;
    /// A leaf's item, or 0 and up for the second child of an inner node; the first is next to it.
    std::uint32_t item = 0;
    std::uint32_t second_child = 0;  // 0: a leaf

    [[nodiscard]] bool is_leaf() const { return second_child == 0; }
  };

  /// More than a walk down the tree has to remember: it halves its items, of which there are fewer
  /// than 2³².
  static constexpr std::size_t deepest = 40;

  explicit BoxTree(const std::vector<Box>& boxes) {
    std::vector<std::uint32_t> items(boxes.size());
    std::iota(items.begin(), items.end(), 0U);
    nodes_.reserve(2 * boxes.size());
    if (!boxes.empty()) {
      build(boxes, items, 0, items.size());
    }
  }

  /// The root is node 0; empty where there are no boxes.
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }

  /// Calls `visit(item)` for each box that meets `query`.
  template <class Visit>
  void find(const Box& query, Visit&& visit) const {
    std::array<std::uint32_t, deepest> stack;
    std::size_t depth = 0;
    if (!nodes_.empty()) {
      stack[depth++] = 0;
    }
    while (depth > 0) {
      const std::uint32_t index = stack[--depth];
      const Node& node = nodes_[index];
      if (!boxes_meet(node.box, query)) {
        continue;
      }
      if (node.is_leaf()) {
        visit(node.item);
      } else {
        stack[depth++] = node.second_child;
        stack[depth++] = index + 1;
      }
    }
  }

 private:
  void build(const std::vector<Box>& boxes, std::vector<std::uint32_t>& items, std::size_t begin,
             std::size_t end) {
    const std::size_t self = nodes_.size();
    nodes_.emplace_back();
    Box centers;
    for (std::size_t i = begin; i < end; ++i) {
      nodes_[self].box.include(boxes[items[i]].min);
      nodes_[self].box.include(boxes[items[i]].max);
      centers.include(boxes[items[i]].center());
    }
    if (end - begin == 1) {
      nodes_[self].item = items[begin];
      return;
    }
    const dvec3 extent = centers.extent();
    const int axis =
        extent.x >= extent.y ? (extent.x >= extent.z ? 0 : 2) : (extent.y >= extent.z ? 1 : 2);
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return items.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
      return boxes[a].center()[axis] < boxes[b].center()[axis];
    });
    build(boxes, items, begin, middle);
    nodes_[self].second_child = static_cast<std::uint32_t>(nodes_.size());
    build(boxes, items, middle, end);
  }

  std::vector<Node> nodes_;
};

}  // namespace collage
