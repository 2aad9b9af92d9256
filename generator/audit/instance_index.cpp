#include "audit/instance_index.h"

#include <algorithm>
#include <limits>

#include <tbb/parallel_for.h>

#include "geometry/bounding_sphere.h"
#include "geometry/box_tree_search.h"
#include "geometry/boxes.h"
#include "geometry/shapes_of.h"

namespace collage {
namespace {

Solid solid_of(const Mesh& mesh) {
  const Sphere sphere = smallest_enclosing_sphere(mesh.positions);
  return {mesh, sphere.center, sphere.radius};
}

/// How far the points of a tree reach along a direction: the largest dot product.
double reach(const BoxTree& points, const dvec3& direction) {
  double farthest = -std::numeric_limits<double>::infinity();
  const auto short_of = [&](const Box& box) {
    return -glm::dot(direction, box.center()) - glm::dot(glm::abs(direction), 0.5 * box.extent());
  };
  visit_lowest_first(points, short_of, -farthest, [&](const BoxTree::Node& leaf) {
    farthest = -short_of(leaf.box);
    return -farthest;
  });
  return farthest;
}

}  // namespace

struct InstanceIndex::Shape {
  Solid solid;
  BoxTree vertices;

  explicit Shape(const Mesh& mesh)
      : solid(solid_of(mesh)), vertices(boxes_of_points(mesh.positions)) {}

  [[nodiscard]] Box world_box(const Instance& instance) const {
    const glm::dmat3 rows = glm::transpose(glm::mat3_cast(instance.rotation)) * instance.scale;
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
      box.min[axis] = instance.translation[axis] - reach(vertices, -rows[axis]);
      box.max[axis] = instance.translation[axis] + reach(vertices, rows[axis]);
    }
    return box;
  }
};

InstanceIndex::InstanceIndex(std::span<const Mesh* const> elements,
                             std::span<const Instance> instances)
    : elements_(elements.begin(), elements.end()),
      instances_(instances),
      shapes_(shapes_of<Shape>(elements)),
      tree_({}) {
  boxes_.resize(instances.size());
  tbb::parallel_for(std::uint32_t{0}, static_cast<std::uint32_t>(boxes_.size()),
                    [&](std::uint32_t i) { boxes_[i] = shape(i).world_box(instances[i]); });
  tree_ = BoxTree(boxes_);
}

const InstanceIndex::Shape& InstanceIndex::shape(std::uint32_t instance) const {
  return *shapes_[instances_[instance].element];
}

const Solid& InstanceIndex::solid(std::uint32_t instance) const { return shape(instance).solid; }

dvec3 InstanceIndex::unit_from_world(std::uint32_t instance, const dvec3& point) const {
  return solid(instance).unit_from_mesh(instances_[instance].element_from_world(point));
}

std::optional<InstanceIndex::Nearest> InstanceIndex::nearest(const dvec3& point,
                                                             double max_distance) const {
  Nearest best{0, max_distance, 0.0};
  bool found = false;
  const auto look_at = [&](const BoxTree::Node& leaf) {
    const double unit = instances_[leaf.item].scale * solid(leaf.item).radius();
    const dvec3 query = unit_from_world(leaf.item, point);
    best.error = std::max(best.error, ClosestPointIndex::error(query) * unit);
    if (const auto closest = solid(leaf.item).surface().find(query, best.distance / unit)) {
      best.instance = leaf.item;
      best.distance = closest->distance * unit;
      found = true;
    }
    return best.distance * best.distance;
  };
  visit_lowest_first(
      tree_, [&](const Box& box) { return squared_distance(box, point); },
      max_distance * max_distance, look_at);
  return found ? std::optional(best) : std::nullopt;
}

std::optional<std::uint32_t> InstanceIndex::holder(const dvec3& point) const {
  // Above 0, and so large that threads which flush denormal numbers to 0 see that.
  constexpr double in_box = std::numeric_limits<double>::min();
  std::optional<std::uint32_t> first;
  visit_lowest_first(
      tree_, [&](const Box& box) { return squared_distance(box, point); }, in_box,
      [&](const BoxTree::Node& leaf) {
        if ((!first || leaf.item < *first) &&
            solid(leaf.item).inside(unit_from_world(leaf.item, point))) {
          first = leaf.item;
        }
        return in_box;
      });
  return first;
}

}  // namespace collage
