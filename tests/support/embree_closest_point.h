#pragma once

#include <optional>
#include <vector>

#include "geometry/embree_scene.h"
#include "geometry/mesh.h"

namespace collage::test {

/// ClosestPointIndex's slow twin, by Embree's point query over single triangles.
class EmbreeClosestPoint {
 public:
  /// Of a mesh within the unit ball.
  explicit EmbreeClosestPoint(Mesh mesh)
      : mesh_(std::move(mesh)), scene_(embree_triangles(mesh_), RTC_SCENE_FLAG_NONE) {}

  /// Distance of the nearest point; nothing where that is not below `limit`.
  [[nodiscard]] std::optional<double> distance(const dvec3& query, double limit) const;

 private:
  struct Search;
  static bool visit(RTCPointQueryFunctionArguments* arguments);

  Mesh mesh_;
  EmbreeScene scene_;
};

}  // namespace collage::test
