#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "geometry/box_tree.h"
#include "geometry/instance.h"
#include "geometry/solid.h"

namespace collage {

/// Answers which instance is nearest to a point and which one holds it, by a hierarchy over the
/// instances' boxes and one Solid for each different mesh. Lengths in world units. Safe to query
/// from many threads; queries allocate nothing.
/// Build O(n log n) for n instances, about 200 bytes each; query O(log n) where few boxes overlap.
class InstanceIndex {
 public:
  /// An instance's `element` is an index into `elements`; the same mesh may stand there more than
  /// once. Elements have triangles, scales are above 0; meshes and instances must outlive the
  /// index.
  InstanceIndex(std::span<const Mesh* const> elements, std::span<const Instance> instances);

  [[nodiscard]] std::span<const Mesh* const> elements() const { return elements_; }
  [[nodiscard]] std::span<const Instance> instances() const { return instances_; }
  /// For each instance the smallest box around its vertices, up to rounding.
  [[nodiscard]] const std::vector<Box>& boxes() const { return boxes_; }
  /// Over boxes(); its items are the instances.
  [[nodiscard]] const BoxTree& tree() const { return tree_; }
  /// The solid of an instance's element, in units of its mesh.
  [[nodiscard]] const Solid& solid(std::uint32_t instance) const;

  struct Nearest {
    std::uint32_t instance = 0;
    /// To the surface of that instance, from outside or inside.
    double distance = 0.0;
    /// The distance to the nearest surface of all is in [distance - error, distance]; about 10⁻⁶
    /// of the sizes of the instances looked at.
    double error = 0.0;
  };
  /// Nothing where no surface is nearer than `max_distance` by more than such an error.
  [[nodiscard]] std::optional<Nearest> nearest(const dvec3& point, double max_distance) const;

  /// The first of the instances whose solid holds the point; nothing where none does.
  [[nodiscard]] std::optional<std::uint32_t> holder(const dvec3& point) const;

 private:
  struct Shape;

  std::vector<const Mesh*> elements_;
  std::span<const Instance> instances_;
  /// By element.
  std::vector<std::shared_ptr<const Shape>> shapes_;
  std::vector<Box> boxes_;
  BoxTree tree_;

  [[nodiscard]] const Shape& shape(std::uint32_t instance) const;
  [[nodiscard]] dvec3 unit_from_world(std::uint32_t instance, const dvec3& point) const;
};

}  // namespace collage
