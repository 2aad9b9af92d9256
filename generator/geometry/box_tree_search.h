#pragma once

#include <array>
#include <utility>

#include "geometry/box_tree.h"

namespace collage {

/// Branch and bound: finds the leaf of least cost without looking at most of the others.
/// `bound(box)` is no more than the cost of anything in the box. `visit(leaf)` is called for a leaf
/// whose bound is below the limit, and gives the new limit, which must not rise. Of two children
/// the one with the lower bound comes first. Allocates nothing.
template <class Bound, class Visit>
void visit_lowest_first(const BoxTree& tree, const Bound& bound, double limit, const Visit& visit) {
  struct Entry {
    std::uint32_t node;
    double bound;
  };
  const std::vector<BoxTree::Node>& nodes = tree.nodes();
  const auto entry = [&](std::uint32_t node) { return Entry{node, bound(nodes[node].box)}; };
  // The tree halves its items, so that it is at most 33 deep for the 2³² that it can have.
  std::array<Entry, 40> stack;
  std::size_t depth = 0;
  if (!nodes.empty()) {
    stack[depth++] = entry(0);
  }
  while (depth > 0) {
    const Entry top = stack[--depth];
    if (!(top.bound < limit)) {
      continue;
    }
    const BoxTree::Node& node = nodes[top.node];
    if (node.is_leaf()) {
      limit = visit(node);
      continue;
    }
    Entry first = entry(top.node + 1);
    Entry second = entry(node.second_child);
    if (second.bound < first.bound) {
      std::swap(first, second);
    }
    stack[depth++] = second;
    stack[depth++] = first;
  }
}

}  // namespace collage
