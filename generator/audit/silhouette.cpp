#include "audit/silhouette.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <tbb/parallel_for.h>

#include "audit/batches.h"
#include "geometry/boxes.h"
#include "geometry/ray_scene.h"

namespace collage {
namespace {

using Pixel = SilhouettePicture::Pixel;

/// The square that shows all of a box from one side.
struct Canvas {
  dvec3 direction;
  dvec3 right;
  dvec3 up;
  /// Centre of the square, on this side of the box.
  dvec3 center;
  double side;

  Canvas(const Box& box, const dvec3& towards_viewer) : direction(towards_viewer) {
    const dvec3 vertical = std::abs(direction.y) < 0.999 ? dvec3(0, 1, 0) : dvec3(0, 0, -1);
    right = glm::normalize(glm::cross(vertical, direction));
    up = glm::cross(direction, right);
    const auto length_along = [&](const dvec3& axis) {
      return glm::dot(glm::abs(axis), box.extent());
    };
    side = std::max(length_along(right), length_along(up));
    center = box.center() + length_along(direction) * direction;
  }

  [[nodiscard]] dvec3 pixel_center(int column, int row, int resolution) const {
    const double x = (column + 0.5) / resolution - 0.5;
    const double y = 0.5 - (row + 0.5) / resolution;
    return center + side * (x * right + y * up);
  }
};

Pixel pixel_of(bool in_target, bool in_sculpture) {
  if (in_target) {
    return in_sculpture ? Pixel::both : Pixel::target;
  }
  return in_sculpture ? Pixel::sculpture : Pixel::neither;
}

SilhouettePicture draw(const RayScene& target, const RayScene& sculpture, const Canvas& canvas,
                       int resolution) {
  SilhouettePicture picture{resolution, resolution, {}};
  picture.pixels.resize(static_cast<std::size_t>(resolution) * resolution);
  tbb::parallel_for(0, resolution, [&](int row) {
    for (int column = 0; column < resolution; ++column) {
      const dvec3 origin = canvas.pixel_center(column, row, resolution);
      picture.pixels[static_cast<std::size_t>(row) * resolution + column] =
          pixel_of(target.occluded(origin, -canvas.direction),
                   sculpture.occluded(origin, -canvas.direction));
    }
  });
  return picture;
}

RayScene scene_of(const Mesh& mesh, const Box& box) {
  static const Instance as_it_is;
  const Mesh* const element = &mesh;
  return {{&element, 1}, {&as_it_is, 1}, {&box, 1}};
}

}  // namespace

double SilhouettePicture::iou() const {
  const auto share = [&](Pixel which) { return std::count(pixels.begin(), pixels.end(), which); };
  const auto both = share(Pixel::both);
  const auto either = both + share(Pixel::target) + share(Pixel::sculpture);
  return either == 0 ? 1.0 : static_cast<double>(both) / static_cast<double>(either);
}

std::vector<dvec3> view_directions(int count) {
  const double golden_angle = glm::pi<double>() * (3.0 - std::sqrt(5.0));
  std::vector<dvec3> directions;
  for (int n = 0; n < count; ++n) {
    const double y = 1.0 - (n + 0.5) / count;
    const double r = std::sqrt(1.0 - y * y);
    directions.emplace_back(r * std::sin(n * golden_angle), y, r * std::cos(n * golden_angle));
  }
  return directions;
}

Silhouette silhouette(const Mesh& target, const InstanceIndex& sculpture,
                      const SilhouetteOptions& options, Status& status) {
  const std::array both{bounding_box(target), box_around(sculpture.boxes())};
  const RayScene target_scene = scene_of(target, both[0]);
  const RayScene sculpture_scene(sculpture.elements(), sculpture.instances(), sculpture.boxes());
  const std::vector<dvec3> directions = view_directions(options.views);

  Silhouette result;
  result.worst = INFINITY;
  double sum = 0.0;
  in_batches(directions.size(), 1, "outlines", status, [&](std::size_t n, std::size_t) {
    SilhouettePicture picture = draw(target_scene, sculpture_scene,
                                     Canvas(box_around(both), directions[n]), options.resolution);
    const double iou = picture.iou();
    result.views.push_back({directions[n], iou});
    sum += iou;
    if (iou < result.worst) {
      result.worst = iou;
      result.worst_direction = directions[n];
      result.worst_picture = std::move(picture);
    }
  });
  result.mean = sum / static_cast<double>(directions.size());
  return result;
}

}  // namespace collage
