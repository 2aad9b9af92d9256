#include <cmath>

#include <fmt/format.h>
#include <tbb/global_control.h>

#include "base/error.h"
#include "base/stopwatch.h"
#include "bench/bar.h"
#include "geometry/models.h"
#include "packing/pack.h"
#include "support/embree_closest_point.h"
#include "support/exact_packer.h"
#include "support/meshes.h"
#include "support/thesis_twin.h"

namespace collage::bench {
namespace {

/// Thin enough for 335,000 of them in the bunny at 400 voxels.
Mesh ring() { return test::torus_mesh(1.0, 0.27, 32, 16); }

PackingOptions to_hole(double threshold) {
  PackingOptions options;
  options.scaling = Scaling::to_hole;
  options.threshold = threshold;
  return options;
}

std::vector<Bar> against_the_thesis() {
  const Mesh mesh = ring();
  const MeshTarget target(make_teapot(12));
  const Element element(mesh);
  const std::vector<Ingredient> ingredients{{element, {1.0}, 1.0}};
  const VoxelGrid grid = target.voxels(100, 0.5, 1);
  const PackingOptions options = to_hole(0.01);
  Status status;
  const ClearanceField field(target, grid, status);
  Packing packing;
  // As one packing takes a tenth of a second, the mean of a few.
  const auto seconds = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    constexpr int runs = 10;
    double sum = 0.0;
    for (int i = 0; i < runs; ++i) {
      ClearanceField copy = field;
      const Stopwatch watch;
      packing = pack(target, copy, ingredients, options, status);
      sum += watch.seconds();
    }
    return sum / runs;
  };
  const double on_two = seconds(2);
  const double on_one = seconds(1);
  test::ThesisTwin twin(target, grid,
                        {{mesh, element.center(), element.size(), element.farthest_direction()}},
                        options);
  std::size_t twin_instances = 0;
  const double slow = measure(1, [&] { twin_instances = twin.run().size(); });
  // Theirs are distances in double, ours float and up to 10⁻⁶ below. Once two holes that are as
  // good as equal change places, so do the turns drawn for them, and all that follows is another,
  // just as dense, packing.
  const auto instances = static_cast<double>(packing.instances.size());
  if (std::abs(static_cast<double>(twin_instances) / instances - 1.0) > 0.02) {
    throw Error("pack() and its literal twin place different numbers of elements", "mend one");
  }
  const auto bar = [&](const char* threads, double fast, double required) {
    return Bar{fmt::format("teapot, 100 voxels, {} rings of 1,024 faces: the thesis, {}",
                           twin_instances, threads),
               fast,
               "s",
               slow,
               slow / fast,
               Bar::Side::at_least,
               required};
  };
  return {bar("2 threads", on_two, 600.0), bar("1 thread", on_one, 300.0)};
}

std::vector<Bar> against_exact_queries() {
  const Mesh mesh = ring();
  const MeshTarget target(field_mesh("targets/bunny.obj"));
  const Element element(mesh);
  const std::vector<Ingredient> ingredients{{element, {1.0}, 1.0}};
  const PackingOptions options = to_hole(0.0025);
  Status status;
  ClearanceField field(target, target.voxels(400, 0.5, 1), status);
  ClearanceField copy = field;
  const test::EmbreeClosestPoint embree(in_unit_frame(mesh, element.center(), element.size()));
  const auto by_embree = [&](const Element& /*the only one*/, const dvec3& unit, double limit) {
    return embree.distance(unit, limit);
  };
  Packing packing;
  Packing exact;
  const double fast =
      measure(2, [&] { packing = pack(target, field, ingredients, options, status); });
  const double slow =
      measure(2, [&] { exact = test::exact_pack(target, copy, ingredients, options, by_embree); });
  if (exact.instances.size() != packing.instances.size()) {
    throw Error("pack() and its exact twin place different numbers of elements", "mend one");
  }
  return {{fmt::format("bunny, 400 voxels, {} rings: an Embree query a voxel, 2 threads",
                       packing.instances.size()),
           fast, "CPU s", slow, slow / fast, Bar::Side::at_least, 10.0}};
}

}  // namespace

std::vector<Group> update_bars() {
  return {{"update-thesis", against_the_thesis},
          {"update-exact", against_exact_queries, Group::Meshes::field}};
}

}  // namespace collage::bench
