#include "preview/preview.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <tbb/parallel_for.h>

#include "geometry/instanced_scene.h"
#include "preview/floor_shadow.h"
#include "preview/studio.h"

namespace collage {
namespace {

using glm::vec3;

/// Pixels that are traced together, as many as there are rays in one of Embree's packets.
constexpr int block_width = 4;
constexpr int block_height = 2;
constexpr std::size_t lanes = block_width * block_height;

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
    const int rows = (shot_.height + block_height - 1) / block_height;
    tbb::parallel_for(0, rows, [&](int row) {
      for (int left = 0; left < shot_.width; left += block_width) {
        expose_block(left, row * block_height);
      }
    });
    return std::move(picture_);
  }

 private:
  using Light = std::array<vec3, lanes>;

  void expose_block(int left, int top) {
    Light light{};
    for (std::size_t sample = 0; sample < samples_a_pixel; ++sample) {
      add_sample(left, top, sample, light);
    }
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const int x = left + static_cast<int>(lane) % block_width;
      const int y = top + static_cast<int>(lane) / block_width;
      if (x < shot_.width && y < shot_.height) {
        picture_.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(shot_.width) +
                        static_cast<std::size_t>(x)] = light[lane] / float{samples_a_pixel};
      }
    }
  }

  void add_sample(int left, int top, std::size_t sample, Light& light) const {
    std::array<dvec2, lanes> places;
    std::array<Ray, lanes> rays;
    std::array<RayHit, lanes> hits;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const dvec2 pixel(left + static_cast<int>(lane) % block_width,
                        top + static_cast<int>(lane) / block_width);
      const dvec2 share = (pixel + sample_places[sample]) / dvec2(shot_.width, shot_.height);
      places[lane] = {2.0 * share.x - 1.0, 1.0 - 2.0 * share.y};
      rays[lane] = {camera_.eye, camera_.direction(places[lane].x, places[lane].y)};
    }
    studio_.sculpture.closest(rays, hits);
    std::array<Point, lanes> points;
    std::array<std::size_t, lanes> lane_of;
    std::size_t count = 0;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      if (hits[lane].met()) {
        points[count] = studio_.point(rays[lane], hits[lane]);
        lane_of[count++] = lane;
      } else {
        light[lane] += surroundings(rays[lane], places[lane]);
      }
    }
    Light thrown{};
    throw_back(std::span(points).first(count), lamps_[sample], thrown);
    for (std::size_t i = 0; i < count; ++i) {
      light[lane_of[i]] += thrown[i];
    }
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

  /// What the points throw back of the lamps' light and show of the room.
  void throw_back(std::span<const Point> points, const std::vector<Lamp>& lamps,
                  Light& thrown) const {
    std::array<float, lanes> mirror;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Surface& surface = *points[i].surface;
      const float facing = std::clamp(glm::dot(points[i].normal, points[i].toward_eye), 0.0F, 1.0F);
      mirror[i] = glm::mix(surface.mirror_facing, surface.mirror_edge,
                           surface.mirror_edge > 0.0F ? std::pow(1.0F - facing, 5.0F) : 0.0F);
      thrown[i] = surface.glow + bounce * points[i].color;
    }
    for (const Lamp& lamp : lamps) {
      add_lamp(points, lamp, mirror, thrown);
    }
    add_mirrored(points, mirror, thrown);
  }

  void add_lamp(std::span<const Point> points, const Lamp& lamp,
                const std::array<float, lanes>& mirror, Light& thrown) const {
    const vec3 direction = lamp.direction;
    const vec3 color = lamp.color;
    std::array<Ray, lanes> rays;
    std::array<std::uint8_t, lanes> stopped{};
    std::array<std::size_t, lanes> point_of;
    std::size_t count = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (glm::dot(points[i].normal, direction) > 0.0F &&
          glm::dot(points[i].face, direction) > 0.0F) {
        rays[count] = {points[i].place, direction};
        point_of[count++] = i;
      }
    }
    studio_.sculpture.occluded(std::span(rays).first(count), std::span(stopped).first(count));
    for (std::size_t k = 0; k < count; ++k) {
      if (stopped[k] == 0) {
        const Point& point = points[point_of[k]];
        const Surface& surface = *point.surface;
        const float facing = glm::dot(point.normal, direction);
        const vec3 body = surface.body * (1.0F - mirror[point_of[k]]) * point.color;
        const vec3 shine =
            highlight(surface, point, direction) * glm::mix(vec3(1.0F), point.color, surface.metal);
        thrown[point_of[k]] += facing * (body + shine) * color;
      }
    }
  }

  void add_mirrored(std::span<const Point> points, const std::array<float, lanes>& mirror,
                    Light& thrown) const {
    std::array<Ray, lanes> rays;
    std::array<RayHit, lanes> hits;
    std::array<float, lanes> room;
    std::array<std::size_t, lanes> point_of;
    std::size_t count = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (mirror[i] > 0.0F) {
        const vec3 direction = glm::reflect(-points[i].toward_eye, points[i].normal);
        room[count] = static_cast<float>(studio_room(direction, shot_.bearing));
        if (mirror[i] * std::max(room[count], mirrored_light) < faintest_mirrored) {
          thrown[i] += mirror[i] * room[count] * tint(points[i]);
        } else {
          rays[count] = {points[i].place, direction};
          point_of[count++] = i;
        }
      }
    }
    studio_.sculpture.closest(std::span(rays).first(count), std::span(hits).first(count));
    for (std::size_t k = 0; k < count; ++k) {
      const Point& point = points[point_of[k]];
      const vec3 seen =
          hits[k].met() ? mirrored_light * studio_.point(rays[k], hits[k]).color : vec3(room[k]);
      thrown[point_of[k]] += mirror[point_of[k]] * seen * tint(point);
    }
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
