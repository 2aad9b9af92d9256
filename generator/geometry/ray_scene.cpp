#include "geometry/ray_scene.h"

#include <limits>
#include <optional>

#include "geometry/bounding_sphere.h"
#include "geometry/boxes.h"
#include "geometry/embree_scene.h"
#include "geometry/shapes_of.h"
#include "geometry/solid.h"

namespace collage {
namespace {

/// By how much the boxes grow in the unit frame of all, above what rounding a box and a ray that
/// starts at most `start_distance` away to float can do.
constexpr float padding = 4e-6F;
constexpr double start_distance = 2.0;
/// A ray that still starts farther away than this passes the unit ball, or has left it behind.
constexpr double farthest_start = 3.0;

/// A ray in the unit frame of what it is tested against, started afresh where it comes near, as
/// coordinates of float are the coarser the farther away it starts. Nothing where it cannot meet
/// anything there, or comes from so far that double does not tell.
std::optional<RTCRay> unit_ray(dvec3 origin, const dvec3& direction) {
  const double ahead = -glm::dot(origin, direction) - start_distance;
  if (ahead > 0.0) {
    origin += ahead * direction;
  }
  if (!(glm::length(origin) <= farthest_start)) {
    return std::nullopt;
  }
  return embree_ray(origin, direction);
}

/// A mesh within the unit ball.
struct RayShape {
  Sphere sphere;
  EmbreeScene scene;

  explicit RayShape(const Mesh& mesh) : RayShape(mesh, smallest_enclosing_sphere(mesh.positions)) {}
  RayShape(const Mesh& mesh, const Sphere& ball)
      : sphere(ball),
        scene(embree_triangles(in_unit_frame(mesh, ball.center, ball.radius)),
              RTC_SCENE_FLAG_ROBUST) {}
};

Sphere ball_around(std::span<const Box> boxes) {
  const Box all = box_around(boxes);
  return {all.center(), 0.5 * glm::length(all.extent())};
}

}  // namespace

struct RayScene::Hierarchy {
  std::span<const Instance> instances;
  std::span<const Box> boxes;
  std::vector<std::shared_ptr<const RayShape>> shapes;
  Sphere ball;
  EmbreeScene scene;

  Hierarchy(std::span<const Mesh* const> elements, std::span<const Instance> all,
            std::span<const Box> boxes_of_all)
      : instances(all),
        boxes(boxes_of_all),
        shapes(shapes_of<RayShape>(elements)),
        ball(ball_around(boxes_of_all)),
        scene(geometry(), RTC_SCENE_FLAG_ROBUST) {}

  /// One primitive an instance.
  RTCGeometry geometry() {
    const RTCGeometry made = rtcNewGeometry(embree_device(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(made, static_cast<unsigned>(instances.size()));
    rtcSetGeometryUserData(made, this);
    rtcSetGeometryBoundsFunction(made, give_bounds, nullptr);
    rtcSetGeometryOccludedFunction(made, test_instance);
    return made;
  }

  static void give_bounds(const RTCBoundsFunctionArguments* arguments) {
    const auto& self = *static_cast<const Hierarchy*>(arguments->geometryUserPtr);
    const Box& box = self.boxes[arguments->primID];
    const glm::vec3 low = glm::vec3((box.min - self.ball.center) / self.ball.radius) - padding;
    const glm::vec3 high = glm::vec3((box.max - self.ball.center) / self.ball.radius) + padding;
    *arguments->bounds_o = {low.x, low.y, low.z, 0.0F, high.x, high.y, high.z, 0.0F};
  }

  static void test_instance(const RTCOccludedFunctionNArguments* arguments) {
    const auto& self = *static_cast<const Hierarchy*>(arguments->geometryUserPtr);
    // Rays are asked for one at a time, so that this is an RTCRay.
    auto& ray = *reinterpret_cast<RTCRay*>(arguments->ray);
    if (self.meets(arguments->primID, {ray.org_x, ray.org_y, ray.org_z},
                   {ray.dir_x, ray.dir_y, ray.dir_z})) {
      ray.tfar = -std::numeric_limits<float>::infinity();
    }
  }

  /// The ray is in the unit frame of all.
  [[nodiscard]] bool meets(unsigned index, const dvec3& origin, const dvec3& direction) const {
    const Instance& instance = instances[index];
    const RayShape& shape = *shapes[instance.element];
    const dvec3 start = instance.element_from_world(ball.radius * origin + ball.center);
    const auto ray = unit_ray((start - shape.sphere.center) / shape.sphere.radius,
                              glm::conjugate(instance.rotation) * direction);
    return ray && shape.scene.occluded(*ray);
  }
};

RayScene::RayScene(std::span<const Mesh* const> elements, std::span<const Instance> instances,
                   std::span<const Box> boxes)
    : hierarchy_(std::make_unique<Hierarchy>(elements, instances, boxes)) {}
RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

bool RayScene::occluded(const dvec3& origin, const dvec3& direction) const {
  const Hierarchy& h = *hierarchy_;
  const auto ray = unit_ray((origin - h.ball.center) / h.ball.radius, direction);
  return ray && h.scene.occluded(*ray);
}

}  // namespace collage
