#pragma once

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include "geometry/mesh.h"

namespace collage {

/// One device for the process. Hierarchies are built on one thread, so that they, and with them the
/// choice between equally near triangles, do not depend on the number of threads.
RTCDevice embree_device();

/// An Embree scene of one geometry.
class EmbreeScene {
 public:
  /// Takes the geometry over and builds the hierarchy.
  EmbreeScene(RTCGeometry geometry, RTCSceneFlags flags);
  ~EmbreeScene() { rtcReleaseScene(scene_); }
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  [[nodiscard]] RTCScene get() const { return scene_; }
  /// True where the ray meets something between its `tnear` and `tfar`.
  [[nodiscard]] bool occluded(RTCRay ray) const;

 private:
  RTCScene scene_;
};

/// The mesh's triangles in float.
RTCGeometry embree_triangles(const Mesh& mesh);

}  // namespace collage
