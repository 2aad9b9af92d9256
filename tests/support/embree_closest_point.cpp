#include "support/embree_closest_point.h"

#include "geometry/closest_point.h"

namespace collage::test {

struct EmbreeClosestPoint::Search {
  const Mesh& mesh;
  dvec3 query;
  double best;
  /// What the hierarchy, in float, may be off by.
  double margin;

  [[nodiscard]] float reach() const { return static_cast<float>((best + margin) * (1.0 + 1e-7)); }
};

bool EmbreeClosestPoint::visit(RTCPointQueryFunctionArguments* arguments) {
  auto& search = *static_cast<Search*>(arguments->userPtr);
  const std::size_t t = arguments->primID;
  const dvec3 point = closest_point_on_triangle(search.query, search.mesh.corner(t, 0),
                                                search.mesh.corner(t, 1), search.mesh.corner(t, 2));
  const double distance = glm::distance(search.query, point);
  if (distance >= search.best) {
    return false;
  }
  search.best = distance;
  arguments->query->radius = search.reach();
  return true;
}

std::optional<double> EmbreeClosestPoint::distance(const dvec3& query, double limit) const {
  Search search{mesh_, query, limit, ClosestPointIndex::error(query)};
  const glm::vec3 center(query);
  RTCPointQuery sphere{center.x, center.y, center.z, 0.0F, search.reach()};
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(scene_.get(), &sphere, &context, visit, &search);
  return search.best < limit ? std::optional(search.best) : std::nullopt;
}

}  // namespace collage::test
