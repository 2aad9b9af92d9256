#include "audit/surfaces_within.h"

#include <array>
#include <utility>

#include "geometry/triangle_distance.h"

namespace collage {
namespace {

/// p ↦ matrix p + offset from the element of one instance to that of another.
class Relative {
 public:
  Relative(const Instance& to, const Instance& from)
      : matrix_(glm::mat3_cast(glm::conjugate(to.rotation) * from.rotation) *
                (from.scale / to.scale)),
        absolute_(glm::abs(matrix_[0]), glm::abs(matrix_[1]), glm::abs(matrix_[2])),
        offset_(to.element_from_world(from.translation)) {}

  [[nodiscard]] dvec3 point(const dvec3& p) const { return matrix_ * p + offset_; }
  [[nodiscard]] Box box(const Box& source) const {
    const dvec3 center = point(source.center());
    const dvec3 half = absolute_ * (0.5 * source.extent());
    return {center - half, center + half};
  }
  [[nodiscard]] Corners triangle(const Mesh& mesh, std::uint32_t t) const {
    return {point(mesh.corner(t, 0)), point(mesh.corner(t, 1)), point(mesh.corner(t, 2))};
  }

 private:
  glm::dmat3 matrix_;
  glm::dmat3 absolute_;
  dvec3 offset_;
};

/// No points of two boxes are farther from each other.
double squared_reach(const Box& a, const Box& b) {
  const dvec3 farthest = glm::max(a.max - b.min, b.max - a.min);
  return glm::dot(farthest, farthest);
}

/// Looks for a place of two surfaces within the gap, all in the frame of the first.
class Search {
 public:
  Search(double gap, const SurfaceTree& a, const SurfaceTree& b, const Relative& a_from_b)
      : squared_gap_(gap * gap), a_(a), b_(b), a_from_b_(a_from_b) {}

  bool run() {
    push(pair(0, 0));
    while (depth_ > 0) {
      const Pair top = stack_[--depth_];
      const BoxTree::Node& na = a_.triangles.nodes()[top.a];
      const BoxTree::Node& nb = b_.triangles.nodes()[top.b];
      if (squared_reach(na.box, top.box_b) <= squared_gap_) {
        return true;
      }
      if (!na.is_leaf() || !nb.is_leaf()) {
        open(top, na, nb);
      } else if (triangles_within_gap(na.item, nb.item)) {
        return true;
      }
    }
    return false;
  }

 private:
  struct Pair {
    std::uint32_t a;
    std::uint32_t b;
    Box box_b;
    double squared_distance;
  };

  [[nodiscard]] Pair pair(std::uint32_t a, std::uint32_t b) const {
    const Box box_b = a_from_b_.box(b_.triangles.nodes()[b].box);
    return {a, b, box_b, squared_distance(a_.triangles.nodes()[a].box, box_b)};
  }

  void push(const Pair& pair) {
    if (pair.squared_distance <= squared_gap_) {
      stack_[depth_++] = pair;
    }
  }

  /// In place of a pair the two pairs with the children of the larger box.
  void open(const Pair& top, const BoxTree::Node& na, const BoxTree::Node& nb) {
    const bool open_a =
        nb.is_leaf() || (!na.is_leaf() && na.box.longest_side() > top.box_b.longest_side());
    Pair near = open_a ? pair(top.a + 1, top.b) : pair(top.a, top.b + 1);
    Pair far = open_a ? pair(na.second_child, top.b) : pair(top.a, nb.second_child);
    if (far.squared_distance < near.squared_distance) {
      std::swap(near, far);
    }
    push(far);
    push(near);
  }

  [[nodiscard]] bool triangles_within_gap(std::uint32_t ta, std::uint32_t tb) const {
    const Corners corners_a{a_.mesh.corner(ta, 0), a_.mesh.corner(ta, 1), a_.mesh.corner(ta, 2)};
    const double distance = triangle_distance(corners_a, a_from_b_.triangle(b_.mesh, tb));
    return distance * distance <= squared_gap_;
  }

  double squared_gap_;
  const SurfaceTree& a_;
  const SurfaceTree& b_;
  const Relative& a_from_b_;
  // Each tree halves its items, so that both together are at most 66 deep.
  std::array<Pair, 80> stack_;
  std::size_t depth_ = 0;
};

}  // namespace

bool surfaces_within(double gap, const SurfaceTree& a, const Instance& instance_a,
                     const SurfaceTree& b, const Instance& instance_b) {
  return Search(gap / instance_a.scale, a, b, Relative(instance_a, instance_b)).run();
}

}  // namespace collage
