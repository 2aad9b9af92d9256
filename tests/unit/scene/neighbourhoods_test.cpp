#include "scene/neighbourhoods.h"

#include "base/rng.h"
#include "unit/scene/support.h"

namespace collage {
namespace {

bool holds(const Box& box, const dvec3& point) {
  return glm::all(glm::lessThanEqual(box.min, point)) &&
         glm::all(glm::lessThanEqual(point, box.max));
}

/// Counts how often each instance is there and checks that every box holds what it is round.
void visit(const Neighbourhood& place, const Composition& composition, std::vector<int>& seen) {
  EXPECT_LE(place.parts.size(), 8U);
  EXPECT_LE(place.instances.size(), 16U);
  EXPECT_TRUE(place.parts.empty() || place.instances.empty());
  for (const Neighbourhood& part : place.parts) {
    EXPECT_TRUE(holds(place.box, part.box.min) && holds(place.box, part.box.max));
    visit(part, composition, seen);
  }
  for (const std::uint32_t i : place.instances) {
    ++seen.at(i);
    const Instance& instance = composition.instances[i];
    for (const dvec3& position : composition.elements[instance.element].mesh.positions) {
      EXPECT_TRUE(holds(place.box, instance.world_from_element(position)));
    }
  }
}

double volume(const Box& box) { return box.extent().x * box.extent().y * box.extent().z; }

TEST(Neighbourhoods, HaveEveryInstanceOnceInsideTheirBoxes) {
  const Mesh mesh = testing::cube();
  Rng rng(7, 8);
  const auto number = [&] { return 2.0 * rng.uniform() - 1.0; };
  for (const std::size_t count : {0U, 1U, 16U, 17U, 500U}) {
    std::vector<Instance> instances;
    for (std::size_t i = 0; i < count; ++i) {
      instances.push_back({0,
                           0.1 * rng.uniform(),
                           glm::normalize(glm::dquat(number(), number(), number(), number())),
                           {5 * number(), 5 * number(), 5 * number()}});
    }
    const Composition composition{"x", "", {{"a", mesh, ""}}, instances, nullptr, {}};
    std::vector<int> seen(count, 0);
    visit(neighbourhoods(composition), composition, seen);
    EXPECT_EQ(seen, std::vector<int>(count, 1));
  }
}

TEST(Neighbourhoods, LieApart) {
  const Mesh mesh = testing::cube();
  std::vector<Instance> instances;
  for (int i = 0; i < 512; ++i) {
    // In an order that has nothing to do with where they are.
    const int k = i * 37 % 512;
    instances.push_back({0, 0.1, {1, 0, 0, 0}, {k % 8, k / 8 % 8, k / 64}});
  }
  const Neighbourhood all = neighbourhoods({"x", "", {{"a", mesh, ""}}, instances, nullptr, {}});
  double sum = 0.0;
  for (const Neighbourhood& part : all.parts) {
    sum += volume(part.box);
  }
  EXPECT_EQ(all.parts.size(), 8U);
  EXPECT_LT(sum, volume(all.box));
}

TEST(Neighbourhoods, HoldInstancesAtOnePlace) {
  const Mesh mesh = testing::cube();
  const std::vector<Instance> instances(100);
  const Composition composition{"x", "", {{"a", mesh, ""}}, instances, nullptr, {}};
  std::vector<int> seen(100, 0);
  visit(neighbourhoods(composition), composition, seen);
  EXPECT_EQ(seen, std::vector<int>(100, 1));
}

}  // namespace
}  // namespace collage
