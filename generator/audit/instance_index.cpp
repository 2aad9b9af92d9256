#include "audit/instance_index.h"

#include <algorithm>
#include <array>
#include <limits>

#include <tbb/parallel_for.h>

#include "geometry/bounding_sphere.h"

namespace collage {
namespace {

/// The hierarchy halves its items, so that it is at most 33 deep for 2³² of them.
constexpr std::size_t stack_size = 64;

double squared_distance(const Box& box, const dvec3& point) {
  const dvec3 away = glm::max(glm::max(box.min - point, point - box.max), dvec3(0.0));
  return glm::dot(away, away);
}

bool holds(const Box& box, const dvec3& point) {
  return glm::all(glm::lessThanEqual(box.min, point)) &&
         glm::all(glm::lessThanEqual(point, box.max));
}

Solid solid_of(const Mesh& mesh) {
  const Sphere sphere = smallest_enclosing_sphere(mesh.positions);
  return {mesh, sphere.center, sphere.radius};
}

std::vector<Box> boxes_of(const std::vector<dvec3>& points) {
  std::vector<Box> boxes;
  boxes.reserve(points.size());
  for (const dvec3& point : points) {
    boxes.push_back({point, point});
  }
  return boxes;
}

/// How far the points of a tree reach along a direction: the largest dot product.
double reach(const BoxTree& points, const dvec3& direction) {
  const auto bound = [&](std::uint32_t node) {
    const Box& box = points.nodes()[node].box;
    return glm::dot(direction, box.center()) + glm::dot(glm::abs(direction), 0.5 * box.extent());
  };
  double farthest = -std::numeric_limits<double>::infinity();
  std::array<std::uint32_t, stack_size> stack{0};
  for (std::size_t depth = 1; depth > 0;) {
    const std::uint32_t index = stack[--depth];
    const BoxTree::Node& node = points.nodes()[index];
    if (bound(index) <= farthest) {
      continue;
    }
    if (node.is_leaf()) {
      farthest = bound(index);
      continue;
    }
    const bool second_first = bound(node.second_child) > bound(index + 1);
    stack[depth++] = second_first ? index + 1 : node.second_child;
    stack[depth++] = second_first ? node.second_child : index + 1;
  }
  return farthest;
}

}  // namespace

struct InstanceIndex::Shape {
  Solid solid;
  BoxTree vertices;

  explicit Shape(const Mesh& mesh) : solid(solid_of(mesh)), vertices(boxes_of(mesh.positions)) {}

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
    : instances_(instances), tree_({}) {
  std::vector<const Mesh*> meshes;
  for (const Mesh* mesh : elements) {
    const auto known = std::find(meshes.begin(), meshes.end(), mesh);
    shape_of_element_.push_back(static_cast<std::uint32_t>(known - meshes.begin()));
    if (known == meshes.end()) {
      meshes.push_back(mesh);
    }
  }
  shapes_.resize(meshes.size());
  tbb::parallel_for(std::size_t{0}, meshes.size(),
                    [&](std::size_t i) { shapes_[i] = std::make_unique<Shape>(*meshes[i]); });
  boxes_.resize(instances.size());
  tbb::parallel_for(std::uint32_t{0}, static_cast<std::uint32_t>(boxes_.size()),
                    [&](std::uint32_t i) { boxes_[i] = shape(i).world_box(instances[i]); });
  tree_ = BoxTree(boxes_);
}

InstanceIndex::~InstanceIndex() = default;
InstanceIndex::InstanceIndex(InstanceIndex&&) noexcept = default;
InstanceIndex& InstanceIndex::operator=(InstanceIndex&&) noexcept = default;

const InstanceIndex::Shape& InstanceIndex::shape(std::uint32_t instance) const {
  return *shapes_[shape_of_element_[instances_[instance].element]];
}

const Solid& InstanceIndex::solid(std::uint32_t instance) const { return shape(instance).solid; }

dvec3 InstanceIndex::unit_from_world(std::uint32_t instance, const dvec3& point) const {
  return solid(instance).unit_from_mesh(instances_[instance].element_from_world(point));
}

void InstanceIndex::look_at(std::uint32_t instance, const dvec3& point, Nearest& best,
                            bool& found) const {
  const double unit = instances_[instance].scale * solid(instance).radius();
  const dvec3 query = unit_from_world(instance, point);
  best.error = std::max(best.error, ClosestPointIndex::error(query) * unit);
  if (const auto closest = solid(instance).surface().find(query, best.distance / unit)) {
    best.instance = instance;
    best.distance = closest->distance * unit;
    found = true;
  }
}

std::optional<InstanceIndex::Nearest> InstanceIndex::nearest(const dvec3& point,
                                                             double max_distance) const {
  struct Entry {
    std::uint32_t node;
    double squared_distance;
  };
  const std::vector<BoxTree::Node>& nodes = tree_.nodes();
  Nearest best{0, max_distance, 0.0};
  bool found = false;
  std::array<Entry, stack_size> stack;
  std::size_t depth = 0;
  if (!nodes.empty()) {
    stack[depth++] = {0, squared_distance(nodes[0].box, point)};
  }
  while (depth > 0) {
    const Entry entry = stack[--depth];
    if (entry.squared_distance >= best.distance * best.distance) {
      continue;
    }
    const BoxTree::Node& node = nodes[entry.node];
    if (node.is_leaf()) {
      look_at(node.item, point, best, found);
      continue;
    }
    Entry near{entry.node + 1, squared_distance(nodes[entry.node + 1].box, point)};
    Entry far{node.second_child, squared_distance(nodes[node.second_child].box, point)};
    if (far.squared_distance < near.squared_distance) {
      std::swap(near, far);
    }
    stack[depth++] = far;
    stack[depth++] = near;
  }
  return found ? std::optional(best) : std::nullopt;
}

std::optional<std::uint32_t> InstanceIndex::holder(const dvec3& point) const {
  const std::vector<BoxTree::Node>& nodes = tree_.nodes();
  std::optional<std::uint32_t> first;
  std::array<std::uint32_t, stack_size> stack;
  std::size_t depth = 0;
  if (!nodes.empty()) {
    stack[depth++] = 0;
  }
  while (depth > 0) {
    const std::uint32_t index = stack[--depth];
    const BoxTree::Node& node = nodes[index];
    if (!holds(node.box, point)) {
      continue;
    }
    if (!node.is_leaf()) {
      stack[depth++] = node.second_child;
      stack[depth++] = index + 1;
    } else if ((!first || node.item < *first) &&
               solid(node.item).inside(unit_from_world(node.item, point))) {
      first = node.item;
    }
  }
  return first;
}

}  // namespace collage
