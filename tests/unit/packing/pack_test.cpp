#include "packing/pack.h"

#include <map>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "support/exact_packer.h"
#include "support/finishing_status.h"
#include "support/instances.h"
#include "support/meshes.h"
#include "support/thesis_twin.h"

namespace collage {
namespace {

struct Case {
  Mesh target_mesh = test::blob_mesh(1.0, 0.2, 16);
  std::vector<Mesh> element_meshes{test::torus_mesh(1.0, 0.4, 16, 8)};
  PackingOptions options;
  int resolution = 24;
  std::vector<double> scales{1.0};
  /// Element e lies in the e-th stretch of this width.
  double stretch = 1.0;
};

std::vector<Ingredient> ingredients_of(const Case& setup, const std::vector<Element>& elements) {
  std::vector<Ingredient> ingredients;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const double left = setup.stretch < 1.0 ? setup.stretch * static_cast<double>(e) : 0.0;
    ingredients.push_back({elements[e], setup.scales, 1.0, left, left + setup.stretch});
  }
  return ingredients;
}

struct Result {
  Packing packing;
  std::vector<Element> elements;
};

Result run(const Case& setup, Status&& status = {}) {
  Result result;
  const MeshTarget target(setup.target_mesh);
  for (const Mesh& mesh : setup.element_meshes) {
    result.elements.emplace_back(mesh, setup.options.distance);
  }
  const std::vector<Ingredient> ingredients = ingredients_of(setup, result.elements);
  ClearanceField field(target, target.voxels(setup.resolution, 0.5, 1), status);
  result.packing = pack(target, field, ingredients, setup.options, status);
  return result;
}

/// By exact_pack().
Packing run_twin(const Case& setup, const std::vector<Element>& elements) {
  Status status;
  const MeshTarget target(setup.target_mesh);
  const std::vector<Ingredient> ingredients = ingredients_of(setup, elements);
  ClearanceField field(target, target.voxels(setup.resolution, 0.5, 1), status);
  return test::exact_pack(target, field, ingredients, setup.options);
}

void expect_same(const Packing& a, const Packing& b) {
  test::expect_same_instances(a.instances, b.instances);
  EXPECT_EQ(a.voxels_inside_instances, b.voxels_inside_instances);
  EXPECT_EQ(a.largest_hole, b.largest_hole);
}

Case to_hole(double threshold) {
  Case setup;
  setup.options.scaling = Scaling::to_hole;
  setup.options.threshold = threshold;
  return setup;
}

double radius(const Result& result, const Instance& instance) {
  return instance.scale * result.elements[instance.element].size();
}

dvec3 center(const Result& result, const Instance& instance) {
  return instance.world_from_element(result.elements[instance.element].center());
}

TEST(Pack, PlacesWhatItsLiteralTwinPlaces) {
  for (const double threshold : {0.05, 0.1}) {
    Case setup = to_hole(threshold);
    setup.element_meshes.push_back(test::blob_mesh(1.0, 0.3, 6));
    const Result fast = run(setup);

    const MeshTarget target(setup.target_mesh);
    std::vector<test::TwinElement> twins;
    for (std::size_t e = 0; e < setup.element_meshes.size(); ++e) {
      twins.push_back({setup.element_meshes[e], fast.elements[e].center(), fast.elements[e].size(),
                       fast.elements[e].farthest_direction()});
    }
    test::ThesisTwin twin(target, target.voxels(setup.resolution, 0.5, 1), twins, setup.options);
    const std::vector<Instance> slow = twin.run();

    ASSERT_EQ(fast.packing.instances.size(), slow.size());
    ASSERT_GT(slow.size(), 10U);
    for (std::size_t i = 0; i < slow.size(); ++i) {
      const Instance& a = fast.packing.instances[i];
      const Instance& b = slow[i];
      EXPECT_EQ(a.element, b.element);
      EXPECT_NEAR(a.scale, b.scale, 1e-4 * b.scale);
      EXPECT_LT(glm::distance(center(fast, a), center(fast, b)), 1e-9);
      EXPECT_NEAR(std::abs(glm::dot(a.rotation, b.rotation)), 1.0, 1e-6);
    }
    // Two rays go wrong now and then where they graze an edge; the winding number does not.
    EXPECT_NEAR(static_cast<double>(fast.packing.voxels_inside_instances),
                static_cast<double>(twin.voxels_inside_instances()), 3.0);
  }
}

TEST(Pack, BoundingSpheresNeitherOverlapNorLeaveTheTarget) {
  const Case setup = to_hole(0.04);
  const Result result = run(setup);
  const MeshTarget target(setup.target_mesh);
  const auto& instances = result.packing.instances;
  ASSERT_GT(instances.size(), 50U);
  for (std::size_t i = 0; i < instances.size(); ++i) {
    const dvec3 p = center(result, instances[i]);
    EXPECT_LE(radius(result, instances[i]), target.clearance(p) * (1 + 1e-5));
  }
}

/// Every vertex of every instance keeps clear of every other instance's solid and of the outside.
TEST(Pack, NoVertexIsInsideAnotherInstanceOrOutsideTheTarget) {
  for (const double spacing : {0.0, 0.02}) {
    Case setup = to_hole(0.05);
    setup.options.spacing = spacing;
    const Result result = run(setup);
    const MeshTarget target(setup.target_mesh);
    const double gap = spacing * target.box().longest_side();
    for (const Instance& a : result.packing.instances) {
      const Mesh& mesh = setup.element_meshes[a.element];
      for (const dvec3& position : mesh.positions) {
        const dvec3 world = a.world_from_element(position);
        ASSERT_GE(target.clearance(world), gap - 1e-5);
        for (const Instance& b : result.packing.instances) {
          if (&a == &b) {
            continue;
          }
          const Solid& solid = result.elements[b.element].solid();
          const dvec3 unit =
              solid.unit_from_mesh(glm::conjugate(b.rotation) * (world - b.translation) / b.scale);
          ASSERT_FALSE(glm::length(unit) < 1.0 && solid.inside(unit));
          ASSERT_FALSE(solid.surface().find(unit, gap / radius(result, b) * (1 - 1e-9)));
        }
      }
    }
  }
}

TEST(Pack, GoesFromLargeToSmallDownToTheThreshold) {
  const Case setup = to_hole(0.05);
  const Result result = run(setup);
  const double longest = bounding_box(setup.target_mesh).longest_side();
  double previous = 1e30;
  for (const Instance& instance : result.packing.instances) {
    EXPECT_LE(radius(result, instance), previous);
    EXPECT_GE(radius(result, instance), 0.05 * longest);
    previous = radius(result, instance);
  }
  EXPECT_LT(result.packing.largest_hole, 0.05 * longest);
}

TEST(Pack, FixedScalingUsesTheListedScalesOnly) {
  Case setup;
  setup.options.threshold = 0.02;
  setup.scales = {0.3, 0.15, 0.1};
  const Result result = run(setup);
  std::map<double, int> used;
  for (const Instance& instance : result.packing.instances) {
    ++used[instance.scale];
  }
  EXPECT_EQ(used.size(), 3U);
  for (const auto& [scale, count] : used) {
    EXPECT_TRUE(scale == 0.3 || scale == 0.15 || scale == 0.1) << scale;
  }
  // It ends where the smallest does not fit any more.
  EXPECT_LT(result.packing.largest_hole, 0.1 * result.elements[0].size());
}

/// The thesis's approximation (V.3): a large face is farther away than it should be.
TEST(Pack, KeepsElementsToTheirStretchAndGoesOnWhereOneDoesNotFit) {
  Case setup;
  setup.options.threshold = 0.03;
  setup.element_meshes = {test::torus_mesh(1.0, 0.4, 16, 8), test::torus_mesh(0.5, 0.2, 16, 8)};
  setup.scales = {0.15};
  setup.stretch = 0.45;  // nothing lies in the rightmost tenth
  const Result result = run(setup);
  const Box box = bounding_box(setup.target_mesh);
  std::map<std::uint32_t, int> counts;
  for (const Instance& instance : result.packing.instances) {
    ++counts[instance.element];
    const double across = (center(result, instance).x - box.min.x) / box.extent().x;
    EXPECT_GE(across, instance.element == 0 ? 0.0 : 0.45);
    EXPECT_LE(across, instance.element == 0 ? 0.45 : 0.9);
  }
  EXPECT_GT(counts[0], 3);
  EXPECT_GT(counts[1], counts[0]);
  expect_same(result.packing, run_twin(setup, result.elements));
}

TEST(Pack, DistancesToVerticesAloneLetMoreIn) {
  Case setup = to_hole(0.06);
  setup.element_meshes = {test::box_mesh(dvec3(-1), dvec3(1))};
  const Result exact = run(setup);
  setup.options.distance = Distance::vertices;
  const Result approximate = run(setup);
  EXPECT_GT(approximate.packing.instances.size(), exact.packing.instances.size());
}

TEST(Pack, ElementsTooLargeForTheTargetGiveAnEmptyPacking) {
  Case setup;
  setup.scales = {10.0};
  EXPECT_TRUE(run(setup).packing.instances.empty());
}

TEST(Pack, FarthestVertexPointsToTheNearestSurfaceAndTouchesIt) {
  const Case setup = to_hole(0.1);
  const Result result = run(setup);
  const MeshTarget target(setup.target_mesh);
  const Instance& first = result.packing.instances.front();
  const dvec3 p = center(result, first);
  const dvec3 farthest = first.rotation * result.elements[0].farthest_direction();
  EXPECT_NEAR(glm::dot(farthest, target.direction_to_surface(p)), 1.0, 1e-9);
  EXPECT_NEAR(target.clearance(p + radius(result, first) * farthest), 0.0, 1e-4);
}

/// Bounds, exact queries where they decide and holes filled at the same time change nothing.
TEST(Pack, IsTheSameAsItsExactTwinToTheLastBitWhateverTheNumberOfThreads) {
  std::vector<Case> cases(5, to_hole(0.03));
  cases[1].element_meshes.push_back(test::open_box_mesh(dvec3(-1), dvec3(1)));
  cases[1].options.choose = Choose::alternate;
  cases[2].options.spacing = 0.01;
  cases[2].options.choose = Choose::weighted;
  cases[2].element_meshes.push_back(test::blob_mesh(1.0, 0.3, 6));
  cases[3].options.distance = Distance::vertices;
  cases[4].options.scaling = Scaling::fixed;
  cases[4].options.threshold = 0.01;
  cases[4].scales = {0.2, 0.07, 0.05};
  for (const std::size_t k : {0U, 1U, 2U, 4U}) {
    cases.push_back(cases[k]);
    cases.back().options.climb = true;
    cases.back().options.threshold *= 1.3;  // its twin asks all surfaces about each hole
  }
  for (Case& setup : cases) {
    setup.resolution = 48;
    std::optional<Packing> twin;
    for (const std::size_t threads : {1U, 2U, 5U}) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      const Result result = run(setup);
      if (!twin) {
        twin = run_twin(setup, result.elements);
        EXPECT_GT(twin->instances.size(), 100U);
      }
      SCOPED_TRACE(&setup - cases.data());
      expect_same(result.packing, *twin);
    }
  }
}

TEST(Pack, ClimbingFindsWiderHolesAndFillsMoreWithoutOverlap) {
  Case setup = to_hole(0.04);
  setup.element_meshes = {test::blob_mesh(1.0, 0.0, 16)};
  const Result before = run(setup);
  setup.options.climb = true;
  const Result after = run(setup);
  EXPECT_GT(after.packing.fill_by_voxels(), 1.03 * before.packing.fill_by_voxels());
  const MeshTarget target(setup.target_mesh);
  std::span<const Instance> instances(after.packing.instances);
  for (std::size_t i = 0; i < instances.size(); ++i) {
    const dvec3 here = center(after, instances[i]);
    EXPECT_GE(target.clearance(here), radius(after, instances[i]) * (1.0 - 1e-9));
    for (const Instance& other : instances.first(i)) {
      EXPECT_GE(glm::distance(here, center(after, other)),
                (radius(after, instances[i]) + radius(after, other)) * 0.98);  // of flat faces
    }
  }
}

TEST(Pack, EndsWithWhatIsPlacedWhenAskedTo) {
  Case setup;
  setup.options.scaling = Scaling::to_hole;
  setup.options.threshold = 0.03;
  const Packing whole = run(setup).packing;
  EXPECT_TRUE(whole.complete);
  for (const int threads : {1, 2}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    const Packing part = run(setup, test::FinishingStatus(1)).packing;
    EXPECT_FALSE(part.complete);
    ASSERT_FALSE(part.instances.empty());
    ASSERT_LT(part.instances.size(), whole.instances.size());
    test::expect_same_instances(part.instances,
                                std::span(whole.instances).first(part.instances.size()));
  }
}

TEST(Pack, AnotherSeedGivesAnotherSculpture) {
  Case setup = to_hole(0.1);
  const Packing a = run(setup).packing;
  setup.options.seed = 2;
  const Packing b = run(setup).packing;
  EXPECT_NE(a.instances[0].rotation, b.instances[0].rotation);
}

TEST(Pack, FillOfSpheresByVolumeAndByVoxelsAgree) {
  Case setup = to_hole(0.04);
  setup.element_meshes = {test::blob_mesh(1.0, 0.0, 24)};
  setup.resolution = 40;
  const Result result = run(setup);
  const MeshTarget target(setup.target_mesh);
  const std::vector<Ingredient> ingredients{{result.elements[0], {1.0}, 1.0}};
  const double by_volume = fill(target, ingredients, result.packing.instances);
  EXPECT_GT(by_volume, 0.4);
  EXPECT_NEAR(by_volume, result.packing.fill_by_voxels(), 0.01);
}

}  // namespace
}  // namespace collage
