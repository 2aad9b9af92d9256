#pragma once

#include "geometry/box_tree.h"
#include "geometry/instance.h"
#include "geometry/mesh.h"
#include "geometry/triangle_intersection.h"
#include "geometry/winding_number.h"

namespace collage {

/// A mesh as the audit looks at it: a hierarchy over its triangles, and its parts.
class AuditShape {
 public:
  explicit AuditShape(const Mesh& mesh);

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] const BoxTree& tree() const { return tree_; }
  [[nodiscard]] const Box& box() const { return tree_.nodes().front().box; }
  /// The vertices of each set of triangles that hang together by vertices.
  [[nodiscard]] const std::vector<std::vector<dvec3>>& parts() const { return parts_; }
  /// Every edge is run as often one way as the other: the winding number is whole everywhere, and
  /// the inside ends at the surface. That of an open mesh fades out in its openings.
  [[nodiscard]] bool closed() const { return closed_; }
  /// By the winding number: the fast one where it is clear, else the sum over all triangles.
  [[nodiscard]] bool holds(const dvec3& point) const;

 private:
  const Mesh& mesh_;
  BoxTree tree_;
  WindingNumber winding_number_;
  std::vector<std::vector<dvec3>> parts_;
  bool closed_;
};

/// Box of an instance in the world, from its transformed vertices.
Box world_box(const AuditShape& shape, const Instance& instance);

/// True where the surfaces of two instances have a point in common. Exact for the vertices that
/// world_from_element() gives.
bool surfaces_meet(const AuditShape& a, const Instance& instance_a, const AuditShape& b,
                   const Instance& instance_b);

/// True where, surfaces not meeting, a part of b lies inside of a; where a is open, all of b.
bool lies_inside(const AuditShape& a, const Instance& instance_a, const AuditShape& b,
                 const Instance& instance_b);

/// True where, surfaces not meeting, a part of b lies outside of the target, which is in the
/// world's frame; where the target is open, all of b.
bool lies_outside(const AuditShape& target, const AuditShape& b, const Instance& instance_b);

}  // namespace collage
