#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/box_tree.h"
#include "geometry/four.h"

namespace collage {

/// Says that a child of a tree of fours is a leaf.
inline constexpr std::uint32_t four_tree_leaf = 1U << 31;
/// More than a walk down such a tree has to remember: three more at each of at most 16 levels.
inline constexpr std::size_t four_tree_waiting = 64;

/// Makes a tree of fours of a binary one: of the halves of its halves, which have up to four items
/// in the end. The tree to be made is given
///   add_leaf(items), which returns the leaf's index,
///   add_inner(), which returns the node's index, and
///   set_child(inner, lane, box, items, content) for each of up to four children of that node;
///     `content` is the index of the child, of a leaf with `four_tree_leaf` set,
/// and parents come before their children. Returns the content of the root.
template <class Tree>
class FourTreeBuilder {
 public:
  FourTreeBuilder(const BoxTree& halves, Tree& fours) : halves_(halves.nodes()), fours_(fours) {
    for (const BoxTree::Node& node : halves_) {
      if (node.is_leaf()) {
        items_.push_back(node.item);
      }
    }
  }

  std::uint32_t run() { return build({0, 0, static_cast<std::uint32_t>(items_.size())}); }

 private:
  /// A node of the binary tree; its items are `count` from `first`.
  struct Half {
    std::uint32_t node;
    std::uint32_t first;
    std::uint32_t count;
  };

  [[nodiscard]] std::span<const std::uint32_t> items(const Half& half) const {
    return std::span(items_).subspan(half.first, half.count);
  }
  [[nodiscard]] Half first_half(const Half& of) const {
    return {of.node + 1, of.first, of.count / 2};
  }
  [[nodiscard]] Half second_half(const Half& of) const {
    return {halves_[of.node].second_child, of.first + of.count / 2, of.count - of.count / 2};
  }

  std::uint32_t build(const Half& half) {
    if (half.count <= four_lanes) {
      return four_tree_leaf | fours_.add_leaf(items(half));
    }
    const std::uint32_t inner = fours_.add_inner();
    std::size_t lane = 0;
    const auto add = [&](const Half& child) {
      const std::uint32_t content = build(child);
      fours_.set_child(inner, lane++, halves_[child.node].box, items(child), content);
    };
    for (const Half& child : {first_half(half), second_half(half)}) {
      if (child.count == 1) {
        add(child);
      } else {
        add(first_half(child));
        add(second_half(child));
      }
    }
    return inner;
  }

  const std::vector<BoxTree::Node>& halves_;
  Tree& fours_;
  std::vector<std::uint32_t> items_;
};

}  // namespace collage
