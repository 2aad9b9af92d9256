#include <algorithm>
#include <cmath>

#include "base/stopwatch.h"
#include "bench/bar.h"
#include "preview/preview.h"
#include "support/meshes.h"

namespace collage::bench {
namespace {

/// On a lattice within the unit ball, each turned its own way.
std::vector<Instance> ball_of_instances(std::size_t wanted) {
  const double spacing = std::cbrt(4.0 / 3.0 * glm::pi<double>() / static_cast<double>(wanted));
  const int reach = static_cast<int>(1.0 / spacing) + 1;
  Rng rng(1, 2);
  std::vector<Instance> instances;
  for (int x = -reach; x <= reach; ++x) {
    for (int y = -reach; y <= reach; ++y) {
      for (int z = -reach; z <= reach; ++z) {
        const dvec3 place = spacing * dvec3(x, y, z);
        if (glm::length(place) <= 1.0) {
          const dvec3 axis(rng.uniform() - 0.5, rng.uniform() - 0.5, rng.uniform() - 0.5);
          instances.push_back(
              {0, 0.45 * spacing, glm::normalize(glm::dquat(rng.uniform(), axis)), place});
        }
      }
    }
  }
  return instances;
}

/// From the meshes to the slowest of three views, at 640 x 480.
std::vector<Bar> preview_of_a_ball() {
  const Mesh ring = test::torus_mesh(0.7, 0.3, 32, 16);
  const std::vector<Instance> instances = ball_of_instances(300'000);
  Composition composition;
  composition.elements.push_back({"ring", ring, "#c8102e", Finish::ceramic});
  composition.instances = instances;

  const Stopwatch building_watch;
  const Preview preview(composition, [](const auto&) { return std::nullopt; });
  const double building = building_watch.seconds();
  double slowest = 0.0;
  for (const Bearing bearing : {Bearing{0, 10}, Bearing{35, 20}, Bearing{120, 60}}) {
    const Stopwatch watch;
    const PreviewPicture picture = preview.picture({bearing, 640, 480, Framing::view});
    slowest = std::max(slowest, watch.seconds());
  }
  const double seconds = building + slowest;
  const double baseline = 2.0;
  const double ratio = seconds / baseline;
  return {{"preview of 300,000 instances", seconds, "s", baseline, ratio, Bar::Side::at_most, 1.0}};
}

}  // namespace

std::vector<Group> preview_bars() { return {{"preview", preview_of_a_ball}}; }

}  // namespace collage::bench
