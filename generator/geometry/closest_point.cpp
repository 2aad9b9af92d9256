#include "geometry/closest_point.h"

#include <cmath>
#include <limits>

#include "geometry/embree_scene.h"

namespace collage {
namespace {

struct Search {
  const Mesh* mesh;
  ClosestPointIndex::Surface surface;
  dvec3 query;
  /// How much farther than the best the hierarchy looks, for what it loses in float.
  double margin;
  ClosestPoint best;
};

float rounded_up(double x) {
  const auto nearest = static_cast<float>(x);
  return nearest < x ? std::nextafter(nearest, std::numeric_limits<float>::max()) : nearest;
}

dvec3 closest_corner(const dvec3& p, const dvec3& a, const dvec3& b, const dvec3& c) {
  const auto squared = [&](const dvec3& v) { return glm::dot(v - p, v - p); };
  const dvec3& ab = squared(b) < squared(a) ? b : a;
  return squared(c) < squared(ab) ? c : ab;
}

bool visit_triangle(RTCPointQueryFunctionArguments* arguments) {
  auto& search = *static_cast<Search*>(arguments->userPtr);
  const std::uint32_t triangle = arguments->primID;
  const dvec3 a = search.mesh->corner(triangle, 0);
  const dvec3 b = search.mesh->corner(triangle, 1);
  const dvec3 c = search.mesh->corner(triangle, 2);
  const dvec3 point = search.surface == ClosestPointIndex::Surface::triangles
                          ? closest_point_on_triangle(search.query, a, b, c)
                          : closest_corner(search.query, a, b, c);
  const double distance = glm::distance(search.query, point);
  if (distance >= search.best.distance) {
    return false;
  }
  search.best = {point, distance, triangle};
  arguments->query->radius = rounded_up(distance + search.margin);
  return true;
}

}  // namespace

dvec3 closest_point_on_triangle(const dvec3& p, const dvec3& a, const dvec3& b, const dvec3& c) {
  const dvec3 ab = b - a;
  const dvec3 ac = c - a;
  const dvec3 ap = p - a;
  const double d1 = glm::dot(ab, ap);
  const double d2 = glm::dot(ac, ap);
  if (d1 <= 0.0 && d2 <= 0.0) {
    return a;
  }
  const dvec3 bp = p - b;
  const double d3 = glm::dot(ab, bp);
  const double d4 = glm::dot(ac, bp);
  if (d3 >= 0.0 && d4 <= d3) {
    return b;
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    return a + ab * (d1 / (d1 - d3));
  }
  const dvec3 cp = p - c;
  const double d5 = glm::dot(ab, cp);
  const double d6 = glm::dot(ac, cp);
  if (d6 >= 0.0 && d5 <= d6) {
    return c;
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    return a + ac * (d2 / (d2 - d6));
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 >= d3 && d5 >= d6) {
    return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
  }
  const double denominator = 1.0 / (va + vb + vc);
  return a + ab * (vb * denominator) + ac * (vc * denominator);
}

struct ClosestPointIndex::Hierarchy {
  /// Only positions and triangles.
  Mesh mesh;
  Surface surface;
  EmbreeScene scene;

  Hierarchy(const Mesh& source, Surface what)
      : surface(what), scene(embree_triangles(source), RTC_SCENE_FLAG_NONE) {
    mesh.positions = source.positions;
    mesh.triangles = source.triangles;
  }
};

ClosestPointIndex::ClosestPointIndex(const Mesh& mesh, Surface surface)
    : hierarchy_(std::make_unique<Hierarchy>(mesh, surface)) {}
ClosestPointIndex::~ClosestPointIndex() = default;
ClosestPointIndex::ClosestPointIndex(ClosestPointIndex&&) noexcept = default;
ClosestPointIndex& ClosestPointIndex::operator=(ClosestPointIndex&&) noexcept = default;

std::optional<ClosestPoint> ClosestPointIndex::find(const dvec3& query, double max_distance) const {
  const double margin = error(query);
  RTCPointQuery sphere{static_cast<float>(query.x), static_cast<float>(query.y),
                       static_cast<float>(query.z), 0.0F, rounded_up(max_distance + margin)};
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  Search search{&hierarchy_->mesh, hierarchy_->surface, query, margin, {{}, max_distance, 0}};
  rtcPointQuery(hierarchy_->scene.get(), &sphere, &context, visit_triangle, &search);
  if (search.best.distance >= max_distance) {
    return std::nullopt;
  }
  return search.best;
}

}  // namespace collage
