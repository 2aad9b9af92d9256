#include "geometry/closest_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/embree_scene.h"

namespace collage {
namespace {

/// A disc that holds a triangle, as thick as rounding has it.
struct Disc {
  dvec3 center;
  /// Unit vector at right angles to it; 0 for a triangle without area, which the disc's ball holds.
  dvec3 normal{0.0};
  double radius = 0.0;
  double half_thickness = 0.0;

  explicit Disc(const std::array<dvec3, 3>& triangle)
      : center((triangle[0] + triangle[1] + triangle[2]) / 3.0) {
    const dvec3 area = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    const double length = glm::length(area);
    if (length > 0.0) {
      normal = area / length;
    }
    for (const dvec3& corner : triangle) {
      radius = std::max(radius, glm::distance(center, corner));
      half_thickness = std::max(half_thickness, std::abs(glm::dot(normal, corner - center)));
    }
    // Some room, so that rounding never makes a point look farther than it is.
    radius += 1e-12;
    half_thickness += 1e-12;
  }

  /// Whether all of it is farther from a point than `distance`.
  [[nodiscard]] bool is_beyond(const dvec3& point, double distance) const {
    const dvec3 to_center = center - point;
    const double squared = glm::dot(to_center, to_center);
    const double reach = distance + radius;
    if (squared > reach * reach) {
      return true;
    }
    const double height = glm::dot(normal, to_center);
    const double above = std::max(0.0, std::abs(height) - half_thickness);
    const double beside =
        std::max(0.0, std::sqrt(std::max(0.0, squared - height * height)) - radius);
    return above * above + beside * beside > distance * distance * (1.0 + 1e-12);
  }
};

/// A mesh's triangles, and around each a disc.
struct Facets {
  std::vector<Disc> discs;
  std::vector<std::array<dvec3, 3>> triangles;
};

struct Search {
  const Facets* facets;
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

/// True where the triangle is nearer than the best, or as near and comes before it.
bool Search::visit(std::uint32_t triangle) {
  if (facets->discs[triangle].is_beyond(query, best.distance)) {
    return false;
  }
  const auto& [a, b, c] = facets->triangles[triangle];
  const dvec3 point = surface == ClosestPointIndex::Surface::triangles
                          ? closest_point_on_triangle(query, a, b, c)
                          : closest_corner(query, a, b, c);
  const double distance = glm::distance(query, point);
  if (distance > best.distance || (distance == best.distance && triangle >= best.triangle)) {
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
  Facets facets;
  Surface surface;
  EmbreeScene scene;

  Hierarchy(const Mesh& mesh, Surface what)
      : surface(what), scene(embree_triangles(mesh), RTC_SCENE_FLAG_NONE) {
    facets.discs.reserve(mesh.triangles.size());
    facets.triangles.reserve(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      facets.triangles.push_back({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)});
      facets.discs.emplace_back(facets.triangles.back());
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
