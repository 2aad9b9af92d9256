#include "preview/preview.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <tbb/parallel_for.h>

#include "geometry/instanced_scene.h"
#include "preview/floor_shadow.h"
#include "preview/studio.h"

namespace collage {
namespace {

using glm::vec3;

/// Pixels on a side of the squares that are traced one after the other, as their rays meet the
/// same.
constexpr int tile = 16;

/// Rays leave a surface from this far off, in studio units: float's rounding where they were found.
constexpr float step_off = 4e-5F;
/// Light from neighbours, as a share of the surface's own colour.
constexpr float bounce = 0.02F;
/// How bright a mirror shows what is in the studio.
constexpr float mirrored_light = 0.4F;
/// Where less than this would be seen in a mirror, it shows the room and nothing that hides it.
constexpr float faintest_mirrored = 0.04F;

/// Where the samples lie in a pixel, from its upper left corner.
constexpr std::array<dvec2, samples_a_pixel> sample_places{
    dvec2(0.375, 0.125), dvec2(0.875, 0.375), dvec2(0.125, 0.625), dvec2(0.625, 0.875)};

/// Where a ray from the eye meets the sculpture, as light sees it.
struct Point {
  vec3 place;
  /// Towards the eye's side, unit vectors: of the triangle, and smoothed.
  vec3 face;
  vec3 normal;
  vec3 toward_eye;
  vec3 color;
  const Surface* surface;
};

template <class Values>
auto blend(const Values& values, const uvec3& corners, const glm::vec2& weights) {
  return (1.0 - weights.x - weights.y) * values[corners.x] + double{weights.x} * values[corners.y] +
         double{weights.y} * values[corners.z];
}

/// Blinn's highlight, normalised so that it throws back the same light however wide it is.
float highlight(const Surface& surface, const Point& point, const vec3& toward_light) {
  if (surface.shine == 0.0F) {
    return 0.0F;
  }
  const float power = 1.0F / surface.shine_width;
  const vec3 half = glm::normalize(toward_light + point.toward_eye);
  const float facing = std::max(0.0F, glm::dot(half, point.normal));
  return surface.shine * (power + 8.0F) / 8.0F * std::pow(facing, power);
}

}  // namespace

struct Preview::Studio {
  const Composition& composition;
  CompositionBounds bounds;
  Stand stand;
  SurfaceLooks surfaces;
  Exhibit exhibit;
  InstancedScene sculpture;

  Studio(const Composition& all, const TextureReader& read_texture, const PreviewShown& shown)
      : composition(all),
        bounds(bounds_of(all)),
        stand(stand_of(all, bounds)),
        surfaces(all, read_texture),
        exhibit(exhibit_of(all, shown, stand)),
        sculpture(exhibit.meshes, exhibit.instances) {}

  [[nodiscard]] Point point(const Ray& ray, const RayHit& hit) const;
  [[nodiscard]] vec3 color(const Mesh& mesh, const Surface& surface, const RayHit& hit) const;
};

vec3 Preview::Studio::color(const Mesh& mesh, const Surface& surface, const RayHit& hit) const {
  return surface.texture == nullptr
             ? surface.color
             : surface.texture->at(blend(mesh.uvs, mesh.uv_triangles[hit.triangle], hit.weights));
}

Point Preview::Studio::point(const Ray& ray, const RayHit& hit) const {
  const Instance& instance = exhibit.instances[hit.instance];
  const Mesh& mesh = *exhibit.meshes[instance.element];
  const dvec3 a = mesh.corner(hit.triangle, 0);
  const dvec3 across =
      glm::cross(mesh.corner(hit.triangle, 1) - a, mesh.corner(hit.triangle, 2) - a);
  dvec3 smooth = across;
  if (!mesh.normal_triangles.empty()) {
    smooth = blend(mesh.normals, mesh.normal_triangles[hit.triangle], hit.weights);
    smooth = glm::dot(smooth, smooth) > 0.0 ? smooth : across;
  }
  Point point;
  point.surface = &surfaces.of(instance.element, hit.triangle);
  point.color = color(mesh, *point.surface, hit);
  point.toward_eye = -ray.direction;
  point.face = glm::normalize(instance.rotation * across);
  point.normal = glm::normalize(instance.rotation * smooth);
  if (glm::dot(point.face, point.toward_eye) < 0.0F) {
    point.face = -point.face;
  }
  if (glm::dot(point.normal, point.face) < 0.0F) {
    point.normal = -point.normal;
  }
  point.place = ray.origin + hit.distance * ray.direction + step_off * point.face;
  return point;
}

namespace {

/// One picture of a studio.
template <class Studio>
class Exposure {
 public:
  Exposure(const Studio& studio, const PreviewShot& shot)
      : studio_(studio),
        shot_(shot),
        camera_(frame(studio.stand, studio.bounds, shot.bearing,
                      static_cast<double>(shot.width) / shot.height, shot.framing)),
        shadow_(studio.sculpture, studio.stand, shot.bearing, *floor_light("studio")),
        lamps_(studio_lamps(shot.bearing)) {
    picture_.width = shot.width;
    picture_.height = shot.height;
    picture_.pixels.resize(static_cast<std::size_t>(shot.width) *
                           static_cast<std::size_t>(shot.height));
  }

  PreviewPicture expose() {
    const int across = (shot_.width + tile - 1) / tile;
    const int down = (shot_.height + tile - 1) / tile;
    tbb::parallel_for(0, across * down, [&](int index) {
      expose_tile(tile * (index % across), tile * (index / across));
    });
    return std::move(picture_);
  }

 private:
  void expose_tile(int left, int top) {
    for (int y = top; y < std::min(top + tile, shot_.height); ++y) {
      for (int x = left; x < std::min(left + tile, shot_.width); ++x) {
        vec3 light(0.0F);
        for (std::size_t sample = 0; sample < samples_a_pixel; ++sample) {
          light += seen_at(x, y, sample);
        }
        picture_.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(shot_.width) +
                        static_cast<std::size_t>(x)] = light / float{samples_a_pixel};
      }
    }
  }

  [[nodiscard]] vec3 seen_at(int x, int y, std::size_t sample) const {
    const dvec2 share = (dvec2(x, y) + sample_places[sample]) / dvec2(shot_.width, shot_.height);
    const dvec2 place(2.0 * share.x - 1.0, 1.0 - 2.0 * share.y);
    const Ray ray{camera_.eye, camera_.direction(place.x, place.y)};
    const RayHit hit = studio_.sculpture.closest(ray);
    return hit.met() ? thrown_back(studio_.point(ray, hit), lamps_[sample])
                     : surroundings(ray, place);
  }

  [[nodiscard]] vec3 surroundings(const Ray& ray, const dvec2& place) const {
    const dvec3 backdrop = studio_backdrop(place.x, place.y);
    if (ray.direction.y >= 0.0F) {
      return backdrop;
    }
    const float distance = -ray.origin.y / ray.direction.y;
    const vec3 floor = ray.origin + distance * ray.direction;
    return shaded_floor(backdrop, shadow_.stopped(floor.x, floor.z));
  }

  /// What a point throws back of the lamps' light and shows of the room.
  [[nodiscard]] vec3 thrown_back(const Point& point, const std::vector<Lamp>& lamps) const {
    const Surface& surface = *point.surface;
    const float facing = std::clamp(glm::dot(point.normal, point.toward_eye), 0.0F, 1.0F);
    const float mirror =
        glm::mix(surface.mirror_facing, surface.mirror_edge,
                 surface.mirror_edge > 0.0F ? std::pow(1.0F - facing, 5.0F) : 0.0F);
    vec3 light = surface.glow + bounce * point.color;
    for (const Lamp& lamp : lamps) {
      light += of_lamp(point, lamp, mirror);
    }
    return mirror > 0.0F ? light + mirror * mirrored(point, mirror) * tint(point) : light;
  }

  [[nodiscard]] vec3 of_lamp(const Point& point, const Lamp& lamp, float mirror) const {
    const vec3 direction = lamp.direction;
    const float facing = glm::dot(point.normal, direction);
    if (facing <= 0.0F || glm::dot(point.face, direction) <= 0.0F ||
        studio_.sculpture.occluded({point.place, direction})) {
      return vec3(0.0F);
    }
    const Surface& surface = *point.surface;
    const vec3 body = surface.body * (1.0F - mirror) * point.color;
    const vec3 shine = highlight(surface, point, direction) * tint(point);
    return facing * (body + shine) * vec3(lamp.color);
  }

  /// What a mirror of that strength shows.
  [[nodiscard]] vec3 mirrored(const Point& point, float mirror) const {
    const vec3 direction = glm::reflect(-point.toward_eye, point.normal);
    const auto room = static_cast<float>(studio_room(direction, shot_.bearing));
    if (mirror * std::max(room, mirrored_light) < faintest_mirrored) {
      return vec3(room);
    }
    const Ray ray{point.place, direction};
    const RayHit hit = studio_.sculpture.closest(ray);
    return hit.met() ? mirrored_light * studio_.point(ray, hit).color : vec3(room);
  }

  /// The colour of highlights and mirror images.
  static vec3 tint(const Point& point) {
    return glm::mix(vec3(1.0F), point.color, point.surface->metal);
  }

  const Studio& studio_;
  const PreviewShot& shot_;
  Camera camera_;
  FloorShadow shadow_;
  LampParts lamps_;
  PreviewPicture picture_;
};

}  // namespace

Preview::Preview(const Composition& composition, const TextureReader& read_texture,
                 const PreviewShown& shown)
    : studio_(std::make_unique<Studio>(composition, read_texture, shown)) {}
Preview::~Preview() = default;
Preview::Preview(Preview&&) noexcept = default;
Preview& Preview::operator=(Preview&&) noexcept = default;

PreviewPicture Preview::picture(const PreviewShot& shot) const {
  return Exposure(*studio_, shot).expose();
}

}  // namespace collage
