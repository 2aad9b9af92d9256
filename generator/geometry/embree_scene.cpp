#include "geometry/embree_scene.h"

#include <algorithm>
#include <limits>
#include <new>

#include <tbb/task_arena.h>

namespace collage {

RTCDevice embree_device() {
  // Not "threads=1": that limits oneTBB in the whole process.
  static const RTCDevice instance = rtcNewDevice("set_affinity=0");
  return instance;
}

EmbreeScene::EmbreeScene(std::span<const RTCGeometry> geometries, RTCSceneFlags flags, Build build)
    : scene_(rtcNewScene(embree_device())) {
  for (unsigned id = 0; id < geometries.size(); ++id) {
    rtcCommitGeometry(geometries[id]);
    rtcAttachGeometryByID(scene_, geometries[id], id);
    rtcReleaseGeometry(geometries[id]);
  }
  rtcSetSceneFlags(scene_, flags);
  rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
  if (build == Build::all_threads) {
    rtcCommitScene(scene_);
    return;
  }
  tbb::task_arena one_thread(1);
  one_thread.execute([this] { rtcCommitScene(scene_); });
}

RTCRayHit EmbreeScene::closest(const RTCRay& ray) const {
  RTCRayHit found;
  found.ray = ray;
  found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  found.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
  rtcIntersect1(scene_, &found);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene_, &context, &found);
#endif
  return found;
}

bool EmbreeScene::occluded(RTCRay ray) const {
#if RTC_VERSION_MAJOR >= 4
  rtcOccluded1(scene_, &ray);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene_, &context, &ray);
#endif
  return ray.tfar < 0.0F;
}

RTCRay embree_ray(const glm::vec3& origin, const glm::vec3& direction) {
  RTCRay ray{};
  ray.org_x = origin.x;
  ray.org_y = origin.y;
  ray.org_z = origin.z;
  ray.dir_x = direction.x;
  ray.dir_y = direction.y;
  ray.dir_z = direction.z;
  ray.tfar = std::numeric_limits<float>::infinity();
  ray.mask = ~0U;
  return ray;
}

RTCGeometry embree_triangles(const Mesh& mesh) {
  const RTCGeometry geometry = rtcNewGeometry(embree_device(), RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<glm::vec3*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                              sizeof(glm::vec3), mesh.positions.size()));
  auto* indices = static_cast<uvec3*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(uvec3), mesh.triangles.size()));
  if ((vertices == nullptr && !mesh.positions.empty()) ||
      (indices == nullptr && !mesh.triangles.empty())) {
    rtcReleaseGeometry(geometry);
    throw std::bad_alloc();
  }
  std::copy(mesh.positions.begin(), mesh.positions.end(), vertices);
  std::copy(mesh.triangles.begin(), mesh.triangles.end(), indices);
  return geometry;
}

}  // namespace collage
