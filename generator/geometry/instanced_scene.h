#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include "geometry/instance.h"
#include "geometry/mesh.h"

namespace collage {

struct Ray {
  glm::vec3 origin{0.0F};
  /// Unit vector.
  glm::vec3 direction{0.0F, 0.0F, 1.0F};
};

/// Where a ray first meets a surface, from either side.
struct RayHit {
  /// Along the ray; infinite where it meets nothing, and then the rest means nothing.
  float distance = std::numeric_limits<float>::infinity();
  std::uint32_t instance = 0;
  std::uint32_t triangle = 0;
  /// Weights of the triangle's second and third corner.
  glm::vec2 weights{0.0F};

  [[nodiscard]] bool met() const { return distance < std::numeric_limits<float>::infinity(); }
};

/// Many copies of a few meshes, for pictures of them. Safe to query from many threads.
///
/// Embree's instancing: each different mesh once, in a unit frame of its own, and a matrix a copy.
/// All of it is float: with copies within a few units of the origin, what is nearer than 10⁻⁵ to
/// the start of a ray, or passed by that much, may be judged either way.
/// Build O(n log n) for n instances, about 1 µs and 600 bytes each, on all threads.
class InstancedScene {
 public:
  /// The scales of `instances` are above 0. Neither argument is used after the constructor.
  InstancedScene(std::span<const Mesh* const> elements, std::span<const Instance> instances);
  ~InstancedScene();
  InstancedScene(InstancedScene&&) noexcept;
  InstancedScene& operator=(InstancedScene&&) noexcept;

  [[nodiscard]] RayHit closest(const Ray& ray) const;
  /// Whether the ray meets anything at all.
  [[nodiscard]] bool occluded(const Ray& ray) const;

 private:
  struct Hierarchy;
  std::unique_ptr<Hierarchy> hierarchy_;
};

}  // namespace collage
