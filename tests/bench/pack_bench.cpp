#include <benchmark/benchmark.h>

#include "base/stopwatch.h"
#include "geometry/models.h"
#include "packing/pack.h"
#include "support/meshes.h"
#include "support/thesis_twin.h"

namespace collage {
namespace {

/// The teapot at 100 voxels, filled to the hole with rings of 1,024 faces: pack() on all threads
/// against the literal twin of the thesis on one, in the same run.
void pack_against_literal_twin(benchmark::State& state) {
  Status status;
  PackingOptions options;
  options.scaling = Scaling::to_hole;
  options.threshold = 0.02;
  const Mesh ring = test::torus_mesh(1.0, 0.4, 32, 16);
  const MeshTarget target(make_teapot(12));
  const Element element(ring);
  const std::vector<Ingredient> ingredients{{element, {1.0}, 1.0}};
  const VoxelGrid grid = target.voxels(100, 0.5, 1);
  for (auto _ : state) {
    ClearanceField field(target, grid, status);
    test::ThesisTwin twin(target, grid,
                          {{ring, element.center(), element.size(), element.farthest_direction()}},
                          options);
    const Stopwatch fast;
    const Packing packing = pack(target, field, ingredients, options, status);
    const double fast_seconds = fast.seconds();
    const Stopwatch slow;
    const std::size_t twin_instances = twin.run().size();
    const double slow_seconds = slow.seconds();
    state.counters["instances"] = static_cast<double>(packing.instances.size());
    state.counters["twin_instances"] = static_cast<double>(twin_instances);
    state.counters["pack_seconds"] = fast_seconds;
    state.counters["twin_seconds"] = slow_seconds;
    state.counters["times_faster"] = slow_seconds / fast_seconds;
  }
}
BENCHMARK(pack_against_literal_twin)->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
}  // namespace collage
