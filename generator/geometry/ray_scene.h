#pragma once

#include <memory>
#include <span>

#include "geometry/instance.h"
#include "geometry/mesh.h"

namespace collage {

/// Tells whether a ray meets any instance. Safe to query from many threads.
///
/// Two levels of Embree hierarchies: each different mesh once, in a unit frame of its own, and the
/// boxes of the instances, in the unit frame of all. Both are float, so that a ray that passes an
/// outline nearer than 10⁻⁶ of the size of all may be judged either way; triangles that share an
/// edge have no crack between them.
/// Build O(n log n) for n instances, about 200 bytes each; query O(log n) where few boxes overlap.
class RayScene {
 public:
  /// For each instance a box that holds it; the tighter, the faster. `instances` must outlive the
  /// scene; scales are above 0.
  RayScene(std::span<const Mesh* const> elements, std::span<const Instance> instances,
           std::span<const Box> boxes);
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  /// True where the ray from `origin` along `direction`, a unit vector, meets a triangle, from
  /// either side and however far.
  [[nodiscard]] bool occluded(const dvec3& origin, const dvec3& direction) const;

 private:
  struct Hierarchy;
  std::unique_ptr<Hierarchy> hierarchy_;
};

}  // namespace collage
