#include "geometry/instanced_scene.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

#include "geometry/bounding_sphere.h"
#include "geometry/embree_scene.h"
#include "geometry/shapes_of.h"
#include "geometry/solid.h"

namespace collage {
namespace {

constexpr std::size_t width = 8;  // rays in one of Embree's packets

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

/// Up to eight rays as Embree takes them; `valid` is -1 for each that there is.
struct alignas(32) Packet {
  std::array<int, width> valid{};
  RTCRayHit8 rays;

  explicit Packet(std::span<const Ray> given) {
    for (std::size_t i = 0; i < given.size(); ++i) {
      valid[i] = -1;
      rays.ray.org_x[i] = given[i].origin.x;
      rays.ray.org_y[i] = given[i].origin.y;
      rays.ray.org_z[i] = given[i].origin.z;
      rays.ray.dir_x[i] = given[i].direction.x;
      rays.ray.dir_y[i] = given[i].direction.y;
      rays.ray.dir_z[i] = given[i].direction.z;
      rays.ray.tnear[i] = 0.0F;
      rays.ray.tfar[i] = std::numeric_limits<float>::infinity();
      rays.ray.time[i] = 0.0F;
      rays.ray.mask[i] = ~0U;
      rays.ray.id[i] = 0;
      rays.ray.flags[i] = 0;
      rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
      rays.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
  }

  void intersect(RTCScene scene) {
#if RTC_VERSION_MAJOR >= 4
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    rtcIntersect8(valid.data(), scene, &rays, &arguments);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect8(valid.data(), scene, &context, &rays);
#endif
  }

  void occlude(RTCScene scene) {
#if RTC_VERSION_MAJOR >= 4
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    rtcOccluded8(valid.data(), scene, &rays.ray, &arguments);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded8(valid.data(), scene, &context, &rays.ray);
#endif
  }
};

}  // namespace

struct InstancedScene::Hierarchy {
  std::vector<std::shared_ptr<const UnitShape>> shapes;
  EmbreeScene scene;

  Hierarchy(std::span<const Mesh* const> elements, std::span<const Instance> instances)
      : shapes(shapes_of<UnitShape>(elements)),
        scene(geometries(instances), RTC_SCENE_FLAG_ROBUST) {}

  [[nodiscard]] std::vector<RTCGeometry> geometries(std::span<const Instance> instances) const {
    std::vector<RTCGeometry> result;
    result.reserve(instances.size());
    for (const Instance& instance : instances) {
      result.push_back(embree_instance(*shapes[instance.element], instance));
    }
    return result;
  }
};

InstancedScene::InstancedScene(std::span<const Mesh* const> elements,
                               std::span<const Instance> instances)
    : hierarchy_(std::make_unique<Hierarchy>(elements, instances)) {}
InstancedScene::~InstancedScene() = default;
InstancedScene::InstancedScene(InstancedScene&&) noexcept = default;
InstancedScene& InstancedScene::operator=(InstancedScene&&) noexcept = default;

void InstancedScene::closest(std::span<const Ray> rays, std::span<RayHit> hits) const {
  assert(rays.size() == hits.size());
  for (std::size_t first = 0; first < rays.size(); first += width) {
    const std::size_t count = std::min(width, rays.size() - first);
    Packet packet(rays.subspan(first, count));
    packet.intersect(hierarchy_->scene.get());
    const RTCHit8& hit = packet.rays.hit;
    for (std::size_t i = 0; i < count; ++i) {
      hits[first + i] =
          hit.geomID[i] == RTC_INVALID_GEOMETRY_ID
              ? RayHit{}
              : RayHit{
                    packet.rays.ray.tfar[i], hit.instID[0][i], hit.primID[i], {hit.u[i], hit.v[i]}};
    }
  }
}

void InstancedScene::occluded(std::span<const Ray> rays, std::span<std::uint8_t> stopped) const {
  assert(rays.size() == stopped.size());
  for (std::size_t first = 0; first < rays.size(); first += width) {
    const std::size_t count = std::min(width, rays.size() - first);
    Packet packet(rays.subspan(first, count));
    packet.occlude(hierarchy_->scene.get());
    for (std::size_t i = 0; i < count; ++i) {
      stopped[first + i] = packet.rays.ray.tfar[i] < 0.0F ? 1 : 0;
    }
  }
}

}  // namespace collage
