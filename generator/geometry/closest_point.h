#pragma once

#include <memory>
#include <optional>

#include "geometry/mesh.h"

namespace collage {

struct ClosestPoint {
  dvec3 point{0.0};
  /// From the query to `point`, exact for the stored mesh up to rounding in double.
  double distance = 0.0;
  /// The first of those that are as near.
  std::uint32_t triangle = 0;
};

/// The point of triangle abc nearest to p (Ericson 2005, "Real-Time Collision Detection", 5.1.5).
dvec3 closest_point_on_triangle(const dvec3& p, const dvec3& a, const dvec3& b, const dvec3& c);

/// Finds the nearest point of a mesh that lies within the unit ball round the origin.
///
/// The hierarchy's boxes, which lie flat on what they hold, are float; it is searched
/// `error(query)` farther than the best found, so that the distance is the least of all, whatever
/// bound the search began with.
/// Safe to query from many threads. Build O(n log n), query O(log n) for usual meshes.
class ClosestPointIndex {
 public:
  /// What counts as the surface: all of each triangle, or its corners alone (Muhm 2011, V.3).
  enum class Surface { triangles, vertices };

  explicit ClosestPointIndex(const Mesh& mesh, Surface surface = Surface::triangles);
  ~ClosestPointIndex();
  ClosestPointIndex(ClosestPointIndex&&) noexcept;
  ClosestPointIndex& operator=(ClosestPointIndex&&) noexcept;

  /// Nothing where no point is nearer than `max_distance`. A triangle that is likely to be near,
  /// such as that of a neighbour, as `hint` makes it faster; the distance stays the same. Where
  /// there are points nearer than `near_enough`, it is any of these that is found.
  [[nodiscard]] std::optional<ClosestPoint> find(const dvec3& query, double max_distance,
                                                 std::optional<std::uint32_t> hint = std::nullopt,
                                                 double near_enough = 0.0) const;

  /// How much too far away the hierarchy can take a triangle to be. A plane's height in float is
  /// off by at most 2⁻²⁴ (6 |query| + 3), of three at right angles by √3 times that, which is
  /// 6.2·10⁻⁷ of |query| and 3.1·10⁻⁷; squaring adds 2⁻²³ of the distance.
  [[nodiscard]] static double error(const dvec3& query) {
    return 1e-6 * (1.0 + glm::length(query));
  }

 private:
  class Hierarchy;
  std::unique_ptr<Hierarchy> hierarchy_;
};

}  // namespace collage
