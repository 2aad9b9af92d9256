#pragma once

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <span>

#include "geometry/mesh.h"

namespace collage {

/// One device for the process.
RTCDevice embree_device();

/// An Embree scene.
class EmbreeScene {
 public:
  /// On one thread the hierarchy, and with it the choice between equally near triangles, does not
  /// depend on their number; on all it is faster, for what is never equally near.
  enum class Build { one_thread, all_threads };

  /// Takes the geometries over, numbers them from 0 and builds the hierarchy.
  EmbreeScene(std::span<const RTCGeometry> geometries, RTCSceneFlags flags,
              Build build = Build::one_thread);
  EmbreeScene(RTCGeometry geometry, RTCSceneFlags flags)
      : EmbreeScene(std::span(&geometry, 1), flags) {}
  ~EmbreeScene() { rtcReleaseScene(scene_); }
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  [[nodiscard]] RTCScene get() const { return scene_; }
  /// The ray as far as what it first meets; geometry RTC_INVALID_GEOMETRY_ID where that is nothing.
  [[nodiscard]] RTCRayHit closest(const RTCRay& ray) const;
  /// True where the ray meets something between its `tnear` and `tfar`.
  [[nodiscard]] bool occluded(RTCRay ray) const;

 private:
  RTCScene scene_;
};

/// A ray without end; `direction` is a unit vector.
RTCRay embree_ray(const glm::vec3& origin, const glm::vec3& direction);

/// The mesh's triangles in float.
RTCGeometry embree_triangles(const Mesh& mesh);

}  // namespace collage
