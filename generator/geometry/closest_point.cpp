#include "geometry/closest_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "geometry/boxes.h"
#include "geometry/four_tree.h"

namespace collage {
namespace {

/// Directions with an offset each: how far a point is beyond the planes that they stand on.
struct Planes {
  Points<Four> normal{};
  Four offset{};

  [[nodiscard]] Four height(const Points<Four>& point) const { return dot(normal, point) - offset; }
  void set(std::size_t lane, const dvec3& direction, double distance) {
    set_lane(normal, lane, direction);
    offset[lane] = static_cast<float>(distance);
  }
};

using Corners = std::array<dvec3, 3>;

/// Up to four triangles, each within the prism of its own plane and those upright on its edges.
struct Prisms {
  Planes face;
  std::array<Planes, 3> sides;
  std::array<std::uint32_t, four_lanes> triangles{};

  Prisms() { face.offset = all_four(std::numeric_limits<float>::infinity()); }
  void set(std::size_t lane, std::uint32_t triangle, const Corners& corners);
  /// No more than the squares of the distances to the triangles; infinite for a lane without one.
  [[nodiscard]] Four squared_distance(const Points<Four>& point) const {
    const Four above = face.height(point);
    const Four beside = larger(larger(sides[0].height(point), sides[1].height(point)),
                               larger(sides[2].height(point), Four{}));
    return above * above + beside * beside;
  }
};

/// How far unit vectors may be off, and off right angles to each other.
constexpr double exact_enough = 1e-9;

bool is_unit_and_across(const dvec3& v, const dvec3& other) {
  return std::abs(glm::dot(v, v) - 1.0) < exact_enough &&
         std::abs(glm::dot(v, other)) < exact_enough;
}

/// A triangle too thin to tell its plane is given planes that bound nothing.
void Prisms::set(std::size_t lane, std::uint32_t triangle, const Corners& corners) {
  triangles[lane] = triangle;
  const auto unit = [](const dvec3& v) {
    const double length = glm::length(v);
    return length > 0.0 ? v / length : dvec3(0.0);
  };
  const auto range_along = [&](const dvec3& direction) {
    return std::minmax({glm::dot(direction, corners[0]), glm::dot(direction, corners[1]),
                        glm::dot(direction, corners[2])});
  };
  const dvec3 normal = unit(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  const auto [low, high] = range_along(normal);
  bool is_known = high - low < exact_enough;
  std::array<dvec3, 3> outwards;
  for (std::size_t k = 0; k < 3; ++k) {
    outwards[k] = unit(glm::cross(corners[(k + 1) % 3] - corners[k], normal));
    is_known = is_known && std::abs(glm::dot(outwards[k], normal)) < exact_enough;
  }
  face.set(lane, is_known ? normal : dvec3(0.0), is_known ? low : 0.0);
  for (std::size_t k = 0; k < 3; ++k) {
    sides[k].set(lane, is_known ? outwards[k] : dvec3(0.0),
                 is_known ? range_along(outwards[k]).second : 0.0);
  }
}

/// A box round triangles, turned to lie flat on them.
struct FlatBox {
  /// Unit vectors at right angles to each other.
  std::array<dvec3, 3> axes{dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1)};
  dvec3 middle{0.0};
  dvec3 half_extent{0.0};

  FlatBox(const std::vector<Corners>& all, std::span<const std::uint32_t> triangles);
};

FlatBox::FlatBox(const std::vector<Corners>& all, std::span<const std::uint32_t> triangles) {
  /// Triangles whose normals cancel out more than this face in no one direction.
  constexpr double least_agreement = 0.5;
  dvec3 normal(0.0);
  double area = 0.0;
  dvec3 center(0.0);
  for (const std::uint32_t t : triangles) {
    const dvec3 across = glm::cross(all[t][1] - all[t][0], all[t][2] - all[t][0]);
    normal += across;
    area += glm::length(across);
    center += (all[t][0] + all[t][1] + all[t][2]) / (3.0 * static_cast<double>(triangles.size()));
  }
  if (const double length = glm::length(normal); length > least_agreement * area) {
    normal /= length;
    dvec3 along(0.0);
    for (const std::uint32_t t : triangles) {
      for (const dvec3& corner : all[t]) {
        const dvec3 away = corner - center;
        const dvec3 flat = away - glm::dot(away, normal) * normal;
        along = glm::dot(flat, flat) > glm::dot(along, along) ? flat : along;
      }
    }
    along = glm::normalize(along);
    const dvec3 beside = glm::cross(normal, along);
    // Of what is tiny, or much taller than wide, rounding may take the angles.
    if (is_unit_and_across(normal, along) && is_unit_and_across(along, beside) &&
        is_unit_and_across(beside, normal)) {
      axes = {normal, along, beside};
    }
  }
  for (int k = 0; k < 3; ++k) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const std::uint32_t t : triangles) {
      for (const dvec3& corner : all[t]) {
        const double height = glm::dot(axes[static_cast<std::size_t>(k)], corner);
        low = std::min(low, height);
        high = std::max(high, height);
      }
    }
    middle[k] = 0.5 * (low + high);
    half_extent[k] = 0.5 * (high - low);
  }
}

/// Up to four boxes, and what is in each.
struct FlatBoxes {
  std::array<Planes, 3> middles;
  Points<Four> half_extents{};
  std::array<std::uint32_t, four_lanes> content{};

  FlatBoxes() { half_extents.fill(all_four(-std::numeric_limits<float>::infinity())); }
  void set(std::size_t lane, const FlatBox& box, std::uint32_t what) {
    for (int k = 0; k < 3; ++k) {
      const auto axis = static_cast<std::size_t>(k);
      middles[axis].set(lane, box.axes[axis], box.middle[k]);
    }
    set_lane(half_extents, lane, box.half_extent);
    content[lane] = what;
  }
  /// Infinite for a lane without a box.
  [[nodiscard]] Four squared_distance(const Points<Four>& point) const {
    Four sum{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Four height = middles[axis].height(point);
      const Four away = larger(larger(height, -height) - half_extents[axis], Four{});
      sum += away * away;
    }
    return sum;
  }
};

float rounded_up(double x) {
  const auto nearest = static_cast<float>(x);
  return nearest < x ? std::nextafter(nearest, std::numeric_limits<float>::max()) : nearest;
}

dvec3 closest_corner(const dvec3& p, const dvec3& a, const dvec3& b, const dvec3& c) {
  const auto squared = [&](const dvec3& v) { return glm::dot(v - p, v - p); };
  const dvec3& ab = squared(b) < squared(a) ? b : a;
  return squared(c) < squared(ab) ? c : ab;
}

/// The square of a distance as the hierarchy has to compare it; finite.
float squared_reach(double distance) {
  const float reach = rounded_up(distance);
  return std::min(reach * reach, std::numeric_limits<float>::max());
}

}  // namespace

dvec3 closest_point_on_triangle(const dvec3& p, const dvec3& a, const dvec3& b, const dvec3& c) {
  const dvec3 ab = b - a;
  const dvec3 ac = c - a;
  const dvec3 ap = p - a;
  const double d1 = glm::dot(ab, ap);
  const double d2 = glm::dot(ac, ap);
  if (d1 <= 0.0 && d2 <= 0.0) {
    return a;
  }
  const dvec3 bp = p - b;
  const double d3 = glm::dot(ab, bp);
  const double d4 = glm::dot(ac, bp);
  if (d3 >= 0.0 && d4 <= d3) {
    return b;
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    return a + ab * (d1 / (d1 - d3));
  }
  const dvec3 cp = p - c;
  const double d5 = glm::dot(ab, cp);
  const double d6 = glm::dot(ac, cp);
  if (d6 >= 0.0 && d5 <= d6) {
    return c;
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    return a + ac * (d2 / (d2 - d6));
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 >= d3 && d5 >= d6) {
    return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
  }
  const double denominator = 1.0 / (va + vb + vc);
  return a + ab * (vb * denominator) + ac * (vc * denominator);
}

class ClosestPointIndex::Hierarchy {
 public:
  Hierarchy(const Mesh& mesh, Surface surface);
  void search(const dvec3& query, double near_enough, ClosestPoint& best) const;
  /// True where the triangle is nearer than the best, or as near and comes before it.
  bool visit(std::uint32_t triangle, const dvec3& query, ClosestPoint& best) const;

  std::uint32_t add_leaf(std::span<const std::uint32_t> triangles);
  std::uint32_t add_inner();
  void set_child(std::uint32_t inner, std::size_t lane, const Box& /*box*/,
                 std::span<const std::uint32_t> triangles, std::uint32_t content) {
    boxes_[inner].set(lane, FlatBox(triangles_, triangles), content);
  }

 private:
  struct Waiting {
    float squared_distance;
    std::uint32_t content;
  };

  Surface surface_;
  std::vector<Corners> triangles_;
  std::vector<FlatBoxes> boxes_;
  std::vector<Prisms> prisms_;
  std::uint32_t root_ = 0;
};

ClosestPointIndex::Hierarchy::Hierarchy(const Mesh& mesh, Surface surface) : surface_(surface) {
  triangles_.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    triangles_.push_back({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)});
  }
  const BoxTree tree(boxes_of_triangles(mesh));
  root_ = FourTreeBuilder(tree, *this).run();
}

std::uint32_t ClosestPointIndex::Hierarchy::add_leaf(std::span<const std::uint32_t> triangles) {
  Prisms& prisms = prisms_.emplace_back();
  for (std::size_t lane = 0; lane < triangles.size(); ++lane) {
    prisms.set(lane, triangles[lane], triangles_[triangles[lane]]);
  }
  return static_cast<std::uint32_t>(prisms_.size() - 1);
}

std::uint32_t ClosestPointIndex::Hierarchy::add_inner() {
  boxes_.emplace_back();
  return static_cast<std::uint32_t>(boxes_.size() - 1);
}

bool ClosestPointIndex::Hierarchy::visit(std::uint32_t triangle, const dvec3& query,
                                         ClosestPoint& best) const {
  const auto& [a, b, c] = triangles_[triangle];
  const dvec3 point = surface_ == Surface::triangles ? closest_point_on_triangle(query, a, b, c)
                                                     : closest_corner(query, a, b, c);
  const double distance = glm::distance(query, point);
  if (distance > best.distance || (distance == best.distance && triangle >= best.triangle)) {
    return false;
  }
  best = {point, distance, triangle};
  return true;
}

void ClosestPointIndex::Hierarchy::search(const dvec3& query, double near_enough,
                                          ClosestPoint& best) const {
  const Points<Four> point = all_four(glm::vec3(query));
  const double margin = error(query);
  float reach = squared_reach(best.distance + margin);
  std::array<Waiting, four_tree_waiting> waiting;
  waiting[0] = {0.0F, root_};
  std::size_t count = 1;
  while (count > 0 && best.distance >= near_enough) {
    const Waiting next = waiting[--count];
    if (next.squared_distance > reach) {
      continue;
    }
    if ((next.content & four_tree_leaf) != 0) {
      const Prisms& prisms = prisms_[next.content & ~four_tree_leaf];
      const Four squared = prisms.squared_distance(point);
      const auto visit_lane = [&](std::size_t lane) {
        if (squared[lane] <= reach && visit(prisms.triangles[lane], query, best)) {
          reach = squared_reach(best.distance + margin);
        }
      };
      const std::size_t nearest = least_lane(squared);
      visit_lane(nearest);
      for (std::size_t other = 1; other < four_lanes; ++other) {
        visit_lane(nearest ^ other);
      }
      continue;
    }
    const FlatBoxes& boxes = boxes_[next.content];
    const Four squared = boxes.squared_distance(point);
    const std::size_t farthest = count;
    for (std::size_t lane = 0; lane < four_lanes; ++lane) {
      if (squared[lane] <= reach) {  // in its place, the nearest last
        std::size_t at = count++;
        for (; at > farthest && waiting[at - 1].squared_distance < squared[lane]; --at) {
          waiting[at] = waiting[at - 1];
        }
        waiting[at] = {squared[lane], boxes.content[lane]};
      }
    }
  }
}

ClosestPointIndex::ClosestPointIndex(const Mesh& mesh, Surface surface)
    : hierarchy_(std::make_unique<Hierarchy>(mesh, surface)) {}
ClosestPointIndex::~ClosestPointIndex() = default;
ClosestPointIndex::ClosestPointIndex(ClosestPointIndex&&) noexcept = default;
ClosestPointIndex& ClosestPointIndex::operator=(ClosestPointIndex&&) noexcept = default;

std::optional<ClosestPoint> ClosestPointIndex::find(const dvec3& query, double max_distance,
                                                    std::optional<std::uint32_t> hint,
                                                    double near_enough) const {
  ClosestPoint best{{}, max_distance, 0};
  if (hint) {
    hierarchy_->visit(*hint, query, best);
  }
  hierarchy_->search(query, std::min(near_enough, max_distance), best);
  return best.distance < max_distance ? std::optional(best) : std::nullopt;
}

}  // namespace collage
