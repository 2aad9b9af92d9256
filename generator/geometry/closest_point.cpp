#include "geometry/closest_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/embree_scene.h"

namespace collage {
namespace {

/// A triangle with a ball round it.
struct Facet {
  dvec3 a, b, c;
  dvec3 center;
  double radius;

  Facet(const dvec3& a_, const dvec3& b_, const dvec3& c_)
      : a(a_), b(b_), c(c_), center((a_ + b_ + c_) / 3.0) {
    // With some room, so that rounding never makes a point look farther than it is.
    radius = 1e-12 + std::max({glm::distance(center, a), glm::distance(center, b),
                               glm::distance(center, c)});
  }
};

struct Search {
  const std::vector<Facet>* facets;
  ClosestPointIndex::Surface surface;
  dvec3 query;
  ClosestPoint best;

  bool visit(std::uint32_t triangle);
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

/// True where the triangle is nearer than the best.
bool Search::visit(std::uint32_t triangle) {
  const Facet& facet = (*facets)[triangle];
  const dvec3 to_center = facet.center - query;
  const double reach = best.distance + facet.radius;
  if (glm::dot(to_center, to_center) >= reach * reach) {
    return false;
  }
  const dvec3 point = surface == ClosestPointIndex::Surface::triangles
                          ? closest_point_on_triangle(query, facet.a, facet.b, facet.c)
                          : closest_corner(query, facet.a, facet.b, facet.c);
  const double distance = glm::distance(query, point);
  if (distance >= best.distance) {
    return false;
  }
  best = {point, distance, triangle};
  return true;
}

struct EmbreeSearch : Search {
  /// How much farther than the best the hierarchy looks, for what it loses in float.
  double margin;
};

bool visit_triangle(RTCPointQueryFunctionArguments* arguments) {
  auto& search = *static_cast<EmbreeSearch*>(arguments->userPtr);
  if (!search.visit(arguments->primID)) {
    return false;
  }
  arguments->query->radius = rounded_up(search.best.distance + search.margin);
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
  std::vector<Facet> facets;
  Surface surface;
  EmbreeScene scene;

  Hierarchy(const Mesh& mesh, Surface what)
      : surface(what), scene(embree_triangles(mesh), RTC_SCENE_FLAG_NONE) {
    facets.reserve(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      facets.emplace_back(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
    }
  }
};

ClosestPointIndex::ClosestPointIndex(const Mesh& mesh, Surface surface)
    : hierarchy_(std::make_unique<Hierarchy>(mesh, surface)) {}
ClosestPointIndex::~ClosestPointIndex() = default;
ClosestPointIndex::ClosestPointIndex(ClosestPointIndex&&) noexcept = default;
ClosestPointIndex& ClosestPointIndex::operator=(ClosestPointIndex&&) noexcept = default;

std::optional<ClosestPoint> ClosestPointIndex::find(const dvec3& query, double max_distance,
                                                    std::optional<std::uint32_t> hint) const {
  const double margin = error(query);
  EmbreeSearch search{{&hierarchy_->facets, hierarchy_->surface, query, {{}, max_distance, 0}},
                      margin};
  if (hint) {
    search.visit(*hint);
  }
  RTCPointQuery sphere{static_cast<float>(query.x), static_cast<float>(query.y),
                       static_cast<float>(query.z), 0.0F,
                       rounded_up(search.best.distance + margin)};
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(hierarchy_->scene.get(), &sphere, &context, visit_triangle, &search);
  if (search.best.distance >= max_distance) {
    return std::nullopt;
  }
  return search.best;
}

}  // namespace collage
