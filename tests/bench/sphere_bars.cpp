#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

#include "base/stopwatch.h"
#include "bench/bar.h"
#include "bench/level_set_spheres.h"
#include "geometry/mesh_check.h"
#include "geometry/models.h"
#include "packing/pack.h"

namespace collage::bench {
namespace {

constexpr int voxels = 100;

/// Volumes of spheres, the largest first, and what it took to find them.
struct Spheres {
  std::vector<double> volumes;
  double seconds = 0.0;

  [[nodiscard]] double volume(std::size_t count) const {
    const std::size_t all = std::min(count, volumes.size());
    return std::accumulate(volumes.begin(), volumes.begin() + static_cast<std::ptrdiff_t>(all),
                           0.0);
  }
};

/// Of our spheres the volume is that of their triangles, which do not overlap.
Spheres ours(const Mesh& bunny, double threshold) {
  const Stopwatch watch;
  Status status;
  const MeshTarget target(bunny);
  const Element ball(make_sphere(3));
  const std::vector<Ingredient> ingredients{{ball, {1.0}, 1.0}};
  PackingOptions options;
  options.scaling = Scaling::to_hole;
  options.threshold = threshold;
  options.climb = true;
  ClearanceField field(target, target.voxels(voxels, 0.5, 1), status);
  Spheres result;
  for (const Instance& instance : pack(target, field, ingredients, options, status).instances) {
    result.volumes.push_back(std::pow(instance.scale, 3) * ball.solid().volume());
  }
  std::ranges::sort(result.volumes, std::greater());
  result.seconds = watch.seconds();
  return result;
}

/// With the largest threshold of a few that gives spheres enough to fill as much.
Spheres as_full(const Mesh& bunny, double volume) {
  Spheres spheres;
  for (double threshold = 0.06; threshold > 0.003; threshold *= 0.8) {
    spheres = ours(bunny, threshold);
    if (spheres.volume(spheres.volumes.size()) >= volume) {
      break;
    }
  }
  return spheres;
}

Spheres openvdb(const Mesh& bunny, std::size_t count) {
  const Stopwatch watch;
  Spheres result;
  for (const double radius : level_set_spheres(bunny, voxels, static_cast<int>(count))) {
    result.volumes.push_back(4.0 / 3.0 * glm::pi<double>() * radius * radius * radius);
  }
  result.seconds = watch.seconds();
  return result;
}

std::vector<Bar> against_openvdb() {
  const Mesh bunny = field_mesh("targets/bunny.obj");
  const double percent = 100.0 / enclosed_volume(bunny);
  const Spheres all = ours(bunny, 0.0045);
  std::vector<Bar> bars;
  for (const std::size_t count : {50U, 500U, 1300U, 6000U}) {
    const Spheres theirs = openvdb(bunny, count);
    const double volume = theirs.volume(count);
    const Spheres equal = as_full(bunny, volume);
    const std::size_t spheres = theirs.volumes.size();
    bars.push_back({fmt::format("bunny of {} spheres: OpenVDB", spheres),
                    percent * all.volume(spheres), "% filled", percent * volume,
                    all.volume(spheres) / volume, Bar::Side::at_least, 1.0});
    bars.push_back(
        {fmt::format("bunny, as full of {} as of OpenVDB's {}", equal.volumes.size(), spheres),
         equal.seconds, "s", theirs.seconds, equal.seconds / theirs.seconds, Bar::Side::at_most,
         1.0});
  }
  return bars;
}

}  // namespace

std::vector<Group> sphere_bars() {
  return {{"spheres-openvdb", against_openvdb, Group::Meshes::field, Group::Named::in_part,
           has_level_sets ? "" : "OpenVDB (libopenvdb-dev) was not there when this was built"}};
}

}  // namespace collage::bench
