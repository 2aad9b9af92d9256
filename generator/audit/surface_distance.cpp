#include "audit/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <tbb/parallel_for.h>

#include "audit/batches.h"
#include "geometry/surface_points.h"

namespace collage {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr std::size_t batch = 2000;

/// True where the solid is on one side of a surface point only. Sheets nearer to each other than
/// the step count as one.
bool solid_ends_at(const Solid& solid, const SurfacePoint& point) {
  constexpr double step = 1e-6;  // in the unit frame
  const dvec3 unit = solid.unit_from_mesh(point.position);
  return solid.inside(unit + step * point.normal) != solid.inside(unit - step * point.normal);
}

SurfaceDistance summary(std::vector<double> distances, const SurfaceDistanceOptions& options) {
  std::sort(distances.begin(), distances.end());
  const std::size_t count = distances.size();
  const auto n = static_cast<double>(count);
  SurfaceDistance result;
  result.points = count;
  result.bin_width = distances.back() / static_cast<double>(options.bins);
  result.histogram.resize(options.bins);
  double sum = 0.0;
  for (const double distance : distances) {
    sum += distance;
    const auto bin = static_cast<std::size_t>(distance / result.bin_width);
    ++result.histogram[std::min(bin, options.bins - 1)];
  }
  result.mean = sum / n;
  result.p95 = distances[static_cast<std::size_t>(std::ceil(0.95 * n)) - 1];
  const auto within = std::upper_bound(distances.begin(), distances.end(), options.within);
  result.share_within = static_cast<double>(within - distances.begin()) / n;
  return result;
}

}  // namespace

std::optional<SurfaceDistance> surface_distance(const TargetShape& target,
                                                const InstanceIndex& sculpture,
                                                const SurfaceDistanceOptions& options,
                                                Status& status) {
  if (sculpture.instances().empty()) {
    return std::nullopt;
  }
  std::vector<SurfacePoint> points = spread_over_surface(target.mesh, options.points);
  std::erase_if(points, [&](const auto& point) { return !solid_ends_at(target.solid, point); });
  if (points.empty()) {
    return std::nullopt;
  }
  std::vector<double> distances(points.size());
  in_batches(
      points.size(), batch, "surface points", status, [&](std::size_t begin, std::size_t end) {
        tbb::parallel_for(begin, end, [&](std::size_t i) {
          distances[i] = sculpture.nearest(points[i].position, unbounded)->distance / target.side;
        });
      });
  return summary(std::move(distances), options);
}

}  // namespace collage
