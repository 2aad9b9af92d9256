#pragma once

#include <vector>

#include "geometry/box_tree.h"
#include "geometry/instance.h"
#include "geometry/solid.h"

namespace collage {

/// A mesh as something to bump into: a hierarchy over its triangles, its solid, and one vertex of
/// each part. Refers to the mesh and the solid, which must outlive it.
class CollisionShape {
 public:
  CollisionShape(const Mesh& mesh, const Solid& solid);

  [[nodiscard]] const Mesh& mesh() const { return *mesh_; }
  [[nodiscard]] const BoxTree& tree() const { return tree_; }
  [[nodiscard]] const Solid& solid() const { return *solid_; }
  [[nodiscard]] const std::vector<dvec3>& part_vertices() const { return part_vertices_; }

 private:
  const Mesh* mesh_;
  const Solid* solid_;
  BoxTree tree_;
  std::vector<dvec3> part_vertices_;
};

/// True where the surfaces of two instances come within `gap` of each other, in world units. For a
/// gap of 0 that is where they have a point in common, exactly, for the vertices that
/// world_from_element() gives; else up to rounding.
bool surfaces_come_within(double gap, const CollisionShape& a, const Instance& instance_a,
                          const CollisionShape& b, const Instance& instance_b);

/// True where a part of b has its first vertex inside of a: surfaces not meeting, and a closed,
/// where the part lies inside.
bool has_part_inside(const CollisionShape& a, const Instance& instance_a, const CollisionShape& b,
                     const Instance& instance_b);

/// True where a part of b has its first vertex outside of the target, which stands in the world.
bool has_part_outside(const CollisionShape& target, const CollisionShape& b,
                      const Instance& instance_b);

}  // namespace collage
