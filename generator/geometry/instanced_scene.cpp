#include "geometry/instanced_scene.h"

#include <vector>

#include <tbb/parallel_for.h>

#include "geometry/bounding_sphere.h"
#include "geometry/embree_scene.h"
#include "geometry/shapes_of.h"
#include "geometry/solid.h"

namespace collage {
namespace {

/// A mesh within the unit ball.
struct UnitShape {
  Sphere sphere;
  EmbreeScene scene;

  explicit UnitShape(const Mesh& mesh)
      : UnitShape(mesh, smallest_enclosing_sphere(mesh.positions)) {}
  UnitShape(const Mesh& mesh, const Sphere& ball)
      : sphere(ball),
        scene(embree_triangles(in_unit_frame(mesh, ball.center, ball.radius)),
              RTC_SCENE_FLAG_ROBUST) {}
};

RTCGeometry embree_instance(const UnitShape& shape, const Instance& instance) {
  const glm::mat3 turned(glm::mat3_cast(instance.rotation) *
                         (instance.scale * shape.sphere.radius));
  const glm::mat4x3 world_from_unit(turned[0], turned[1], turned[2],
                                    instance.world_from_element(shape.sphere.center));
  const RTCGeometry geometry = rtcNewGeometry(embree_device(), RTC_GEOMETRY_TYPE_INSTANCE);
  rtcSetGeometryInstancedScene(geometry, shape.scene.get());
  rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, &world_from_unit);
  return geometry;
}

}  // namespace

struct InstancedScene::Hierarchy {
  std::vector<std::shared_ptr<const UnitShape>> shapes;
  EmbreeScene scene;

  Hierarchy(std::span<const Mesh* const> elements, std::span<const Instance> instances)
      : shapes(shapes_of<UnitShape>(elements)),
        scene(geometries(instances), RTC_SCENE_FLAG_ROBUST, EmbreeScene::Build::all_threads) {}

  [[nodiscard]] std::vector<RTCGeometry> geometries(std::span<const Instance> instances) const {
    std::vector<RTCGeometry> result(instances.size());
    tbb::parallel_for(std::size_t{0}, instances.size(), [&](std::size_t i) {
      result[i] = embree_instance(*shapes[instances[i].element], instances[i]);
    });
    return result;
  }
};

InstancedScene::InstancedScene(std::span<const Mesh* const> elements,
                               std::span<const Instance> instances)
    : hierarchy_(std::make_unique<Hierarchy>(elements, instances)) {}
InstancedScene::~InstancedScene() = default;
InstancedScene::InstancedScene(InstancedScene&&) noexcept = default;
InstancedScene& InstancedScene::operator=(InstancedScene&&) noexcept = default;

RayHit InstancedScene::closest(const Ray& ray) const {
  const RTCRayHit found = hierarchy_->scene.closest(embree_ray(ray.origin, ray.direction));
  const RTCHit& hit = found.hit;
  return hit.geomID == RTC_INVALID_GEOMETRY_ID
             ? RayHit{}
             : RayHit{found.ray.tfar, hit.instID[0], hit.primID, {hit.u, hit.v}};
}

bool InstancedScene::occluded(const Ray& ray) const {
  return hierarchy_->scene.occluded(embree_ray(ray.origin, ray.direction));
}

}  // namespace collage
