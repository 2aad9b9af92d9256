#include "fitting/pack_by_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "audit/audit.h"
#include "audit/links.h"
#include "base/error.h"
#include "support/finishing_status.h"
#include "support/instances.h"
#include "support/meshes.h"

namespace collage {
namespace {

struct Case {
  Mesh target_mesh = test::blob_mesh(1.0, 0.2, 16);
  std::vector<Mesh> meshes{test::torus_mesh(1.0, 0.25, 20, 10)};
  std::vector<double> scales{1.0};
  std::vector<double> weights;
  PackingOptions options;
  int resolution = 40;

  Case() {
    options.scaling = Scaling::to_hole;
    options.fit = Fit::shape;
    options.threshold = 0.08;
  }
};

/// Measured once a process: it takes longer than to pack.
ShapeData shape_of(const Mesh& mesh, const Element& element) {
  static std::vector<std::pair<Mesh, ShapeData>> known;
  const auto found = std::ranges::find_if(known, [&](const auto& entry) {
    return entry.first.positions == mesh.positions && entry.first.triangles == mesh.triangles;
  });
  return found != known.end() ? found->second
                              : known.emplace_back(mesh, measure_shape(mesh, element)).second;
}

struct Result {
  Packing packing;
  std::vector<std::unique_ptr<Element>> elements;
  double filled = 0.0;
};

Result run(const Case& setup, Status& status) {
  Result result;
  const MeshTarget target(setup.target_mesh);
  const CollisionShape surface(setup.target_mesh, target.solid());
  FreeSpace space(target, setup.resolution, status);
  std::vector<std::unique_ptr<ShapedElement>> shapes;
  std::vector<ShapeIngredient> ingredients;
  std::vector<Ingredient> plain;
  for (const Mesh& mesh : setup.meshes) {
    result.elements.push_back(std::make_unique<Element>(mesh));
    const Element& element = *result.elements.back();
    shapes.push_back(std::make_unique<ShapedElement>(mesh, element, shape_of(mesh, element)));
    const double weight = setup.weights.empty() ? 1.0 : setup.weights[ingredients.size()];
    ingredients.push_back({*shapes.back(), setup.scales, weight});
    plain.push_back({element, setup.scales, weight});
  }
  result.packing = pack_by_shape({target, &surface}, space, ingredients, setup.options, status);
  result.filled = fill(target, plain, result.packing.instances);
  return result;
}

Result run(const Case& setup) {
  Status status;
  return run(setup, status);
}

Audit judged(const Case& setup, const Packing& packing) {
  Status status;
  AuditInput input;
  input.target = &setup.target_mesh;
  for (const Mesh& mesh : setup.meshes) {
    input.elements.push_back(&mesh);
    input.scales.push_back(setup.options.scaling == Scaling::fixed ? setup.scales
                                                                   : std::vector<double>{});
  }
  input.instances = packing.instances;
  return audit(input, status);
}

std::vector<Case> cases() {
  std::vector<Case> all(6);
  all[1].options.scaling = Scaling::fixed;
  all[1].scales = {0.5, 0.3, 0.2};
  all[2].meshes.push_back(test::box_mesh({-1.0, -0.05, -0.3}, {1.0, 0.05, 0.3}));
  all[2].options.choose = Choose::alternate;
  all[3].meshes = {test::open_box_mesh({-1.0, -0.7, -1.0}, {1.0, 0.7, 1.0})};
  all[4].meshes[0] = test::blob_mesh(1.0, 0.3, 8);
  Mesh other = test::blob_mesh(0.4, 0.0, 6);
  const auto offset = static_cast<std::uint32_t>(all[4].meshes[0].positions.size());
  for (const dvec3& position : other.positions) {
    all[4].meshes[0].positions.push_back(position + dvec3(2.0, 0.0, 0.0));
  }
  for (const uvec3& triangle : other.triangles) {
    all[4].meshes[0].triangles.push_back(triangle + uvec3(offset));
  }
  all[5].options.linking = Linking::seek;
  all[5].options.spacing = 0.01;
  return all;
}

TEST(PackByShape, NothingOverlapsNorSticksOut) {
  for (const Case& setup : cases()) {
    const Result result = run(setup);
    EXPECT_GT(result.packing.instances.size(), 5U);
    const Audit audit = judged(setup, result.packing);
    EXPECT_TRUE(audit.overlaps.empty());
    EXPECT_TRUE(audit.protrusions.empty());
    EXPECT_TRUE(audit.deformed.empty());
  }
}

/// The judge is awake: grown by a tenth, instances overlap.
TEST(PackByShape, InstancesTouchNearly) {
  const Case setup;
  Packing packing = run(setup).packing;
  for (Instance& instance : packing.instances) {
    instance.scale *= 1.1;
  }
  EXPECT_GT(judged(setup, packing).overlaps.size(), packing.instances.size() / 2);
}

TEST(PackByShape, FillsMoreThanBoundingSpheres) {
  Case setup;
  setup.options.threshold = 0.05;
  const Result shape = run(setup);
  const MeshTarget target(setup.target_mesh);
  Status status;
  const Element element(setup.meshes[0]);
  const std::vector<Ingredient> ingredients{{element, setup.scales, 1.0}};
  ClearanceField field(target, target.voxels(setup.resolution, 0.5, 1), status);
  const Packing sphere = pack(target, field, ingredients, setup.options, status);
  EXPECT_GT(shape.filled, 2.0 * fill(target, ingredients, sphere.instances));
}

TEST(PackByShape, ResultsDoNotDependOnTheNumberOfThreads) {
  Case setup;
  setup.meshes.push_back(test::blob_mesh(1.0, 0.3, 6));
  setup.options.linking = Linking::seek;
  setup.options.threshold = 0.12;
  const tbb::global_control many(tbb::global_control::max_allowed_parallelism, 4);
  const Packing parallel = run(setup).packing;
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  test::expect_same_instances(parallel.instances, run(setup).packing.instances);
}

TEST(PackByShape, TheSeedMatters) {
  Case setup;
  const Packing first = run(setup).packing;
  setup.options.seed = 2;
  const Packing second = run(setup).packing;
  EXPECT_NE(first.instances.front().rotation, second.instances.front().rotation);
}

TEST(PackByShape, SizesKeepToTheLimits) {
  Case setup;
  setup.options.largest = 0.15;
  const Result result = run(setup);
  const double side = bounding_box(setup.target_mesh).longest_side();
  double largest = 0.0;
  for (const Instance& instance : result.packing.instances) {
    const double radius = instance.scale * result.elements[0]->size() / side;
    EXPECT_GE(radius, setup.options.threshold * (1.0 - 1e-9));
    EXPECT_LE(radius, 0.15 * (1.0 + 1e-9));
    largest = std::max(largest, radius);
  }
  EXPECT_GT(largest, 0.149);
}

TEST(PackByShape, TheCoreMayHaveAThresholdOfItsOwn) {
  Case setup;
  setup.options.threshold_core = 0.3;
  const Result result = run(setup);
  const MeshTarget target(setup.target_mesh);
  const double side = target.box().longest_side();
  for (const Instance& instance : result.packing.instances) {
    const double radius = instance.scale * result.elements[0]->size() / side;
    const dvec3 center = instance.world_from_element(result.elements[0]->center());
    if (target.clearance(center) > 0.25 * side) {
      EXPECT_GT(radius, 0.1);
    }
  }
  EXPECT_LT(result.packing.instances.size(), run(Case{}).packing.instances.size());
}

TEST(PackByShape, NumbersHoldToWeights) {
  Case setup;
  setup.meshes.push_back(test::blob_mesh(1.0, 0.3, 6));
  setup.weights = {3.0, 1.0};
  setup.options.choose = Choose::weighted;
  setup.options.threshold = 0.05;
  const auto instances = run(setup).packing.instances;
  const auto rings = std::ranges::count(instances, 0U, &Instance::element);
  const double wanted = 0.75 * static_cast<double>(instances.size());
  EXPECT_GT(instances.size(), 20U);
  EXPECT_NEAR(static_cast<double>(rings), wanted, std::max(1.0, 0.05 * wanted));
}

double linked_share(const Case& setup) {
  const Packing packing = run(setup).packing;
  Status status;
  const std::vector<const Mesh*> meshes{&setup.meshes[0]};
  const InstanceIndex index(meshes, packing.instances);
  return find_links(index, status)->linked_share;
}

TEST(PackByShape, RingsLinkAsAskedFor) {
  Case setup;
  setup.meshes = {test::torus_mesh(1.0, 0.18, 24, 10)};
  setup.options.threshold = 0.06;
  setup.options.largest = 0.12;
  setup.options.linking = Linking::avoid;
  EXPECT_EQ(linked_share(setup), 0.0);
  setup.options.linking = Linking::seek;
  EXPECT_GE(linked_share(setup), 0.5);
}

TEST(PackByShape, EndsWithWhatIsPlacedWhenAskedTo) {
  const Case setup;
  const Packing whole = run(setup).packing;
  EXPECT_TRUE(whole.complete);
  test::FinishingStatus at_once(0);
  const Packing one = run(setup, at_once).packing;
  EXPECT_FALSE(one.complete);
  EXPECT_EQ(one.instances.size(), 1U);
  EXPECT_TRUE(judged(setup, one).passed());
  test::FinishingStatus later(60);
  const Packing part = run(setup, later).packing;
  EXPECT_FALSE(part.complete);
  ASSERT_GT(part.instances.size(), 1U);
  ASSERT_LT(part.instances.size(), whole.instances.size());
  test::expect_same_instances(part.instances,
                              std::span(whole.instances).first(part.instances.size()));
}

TEST(PackByShape, StopsWhenAskedTo) {
  class Impatient : public Status {
   public:
    [[nodiscard]] bool stop_requested() const override { return looks_++ > 60; }

   private:
    mutable int looks_ = 0;
  };
  Impatient status;
  EXPECT_THROW(run(Case{}, status), Interrupted);
}

}  // namespace
}  // namespace collage
