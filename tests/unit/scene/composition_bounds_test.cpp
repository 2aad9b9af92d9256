#include "scene/composition_bounds.h"

#include <cmath>

#include <gmock/gmock.h>

#include "base/rng.h"
#include "unit/scene/support.h"

namespace collage {
namespace {

TEST(CompositionBounds, AreThoseOfAllVertices) {
  const Mesh mesh = testing::cube();
  Mesh flat = mesh;
  flat.positions.push_back({100, 100, 100});  // in no triangle, so nowhere
  for (dvec3& position : flat.positions) {
    position.y *= 0.1;
  }
  Rng rng(3, 4);
  const auto number = [&] { return 2.0 * rng.uniform() - 1.0; };
  std::vector<Instance> instances;
  Box box;
  for (int i = 0; i < 500; ++i) {
    instances.push_back({static_cast<std::uint32_t>(i % 2),
                         0.1 + rng.uniform(),
                         glm::normalize(glm::dquat(number(), number(), number(), number())),
                         {5 * number(), 5 * number(), 5 * number()}});
    for (std::size_t v = 0; v < 8; ++v) {
      box.include(instances.back().world_from_element((i % 2 == 0 ? mesh : flat).positions[v]));
    }
  }
  double radius = 0.0;
  const dvec3 axis = box.center();
  for (std::size_t i = 0; i < instances.size(); ++i) {
    for (std::size_t v = 0; v < 8; ++v) {
      const dvec3 p = instances[i].world_from_element((i % 2 == 0 ? mesh : flat).positions[v]);
      radius = std::max(radius, std::hypot(p.x - axis.x, p.z - axis.z));
    }
  }
  const CompositionBounds bounds =
      bounds_of({"x", "", {{"a", mesh, ""}, {"b", flat, ""}}, instances, nullptr, {}});
  EXPECT_EQ(bounds.shown.min, box.min);
  EXPECT_EQ(bounds.shown.max, box.max);
  EXPECT_DOUBLE_EQ(bounds.radius, radius);
}

TEST(CompositionBounds, OutlineNearlySpansAllVertices) {
  Rng rng(5, 6);
  const auto number = [&] { return 2.0 * rng.uniform() - 1.0; };
  const Mesh mesh = testing::cube();
  std::vector<Instance> instances;
  for (int i = 0; i < 500; ++i) {
    const dvec3 direction = glm::normalize(dvec3(number(), number(), number()));
    instances.push_back({0, 0.05, {1, 0, 0, 0}, 3.0 * direction});
  }
  const CompositionBounds bounds = bounds_of({"x", "", {{"a", mesh, ""}}, instances, nullptr, {}});
  EXPECT_EQ(bounds.outline.size(), 128U);
  for (int i = 0; i < 1000; ++i) {
    const dvec3 direction = glm::normalize(dvec3(number(), number(), number()));
    double all = 0.0;
    for (const Instance& instance : instances) {
      for (const dvec3& position : mesh.positions) {
        all = std::max(all, glm::dot(instance.world_from_element(position), direction));
      }
    }
    double outline = 0.0;
    for (const dvec3& point : bounds.outline) {
      outline = std::max(outline, glm::dot(point, direction));
    }
    EXPECT_LE(outline, all);
    EXPECT_GE(outline, all - 0.02 * 6.1);
  }
}

TEST(CompositionBounds, HoldTheProps) {
  const Mesh mesh = testing::cube();
  const std::vector<Instance> instances{{0, 0.5, {1, 0, 0, 0}, {1, 0, 0}}};
  Composition composition{"x", "", {{"a", mesh}}, instances, nullptr, {}};
  composition.props.push_back({"b", mesh});
  const CompositionBounds bounds = bounds_of(composition);
  EXPECT_EQ(bounds.shown.min, dvec3(-1.0));
  EXPECT_EQ(bounds.shown.max, dvec3(1.5, 1.0, 1.0));
  EXPECT_THAT(bounds.outline, ::testing::Contains(dvec3(-1.0, 1.0, 1.0)));
}

TEST(CompositionBounds, HoldTheTarget) {
  const Mesh mesh = testing::cube();
  const Box box{{-1, -1, -1}, {1, 1, 1}};
  const std::vector<Instance> instances{{0, 0.5, {1, 0, 0, 0}, {0, 0, 0}}};
  const CompositionBounds bounds = bounds_of({"x", "", {{"a", mesh, ""}}, instances, &mesh, box});
  EXPECT_EQ(bounds.shown.max, dvec3(0.5));
  EXPECT_DOUBLE_EQ(bounds.radius, std::sqrt(2.0));
  const auto farthest = [](const std::vector<dvec3>& outline) {
    double distance = 0.0;
    for (const dvec3& point : outline) {
      distance = std::max(distance, glm::length(point));
    }
    return distance;
  };
  EXPECT_DOUBLE_EQ(farthest(bounds.outline), std::sqrt(0.75));
  EXPECT_DOUBLE_EQ(farthest(bounds.target_outline), std::sqrt(3.0));
  const CompositionBounds none = bounds_of({"x", "", {{"a", mesh, ""}}, {}, nullptr, box});
  EXPECT_EQ(none.shown.max, dvec3(1.0));
  EXPECT_DOUBLE_EQ(farthest(none.outline), std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(farthest(none.target_outline), std::sqrt(3.0));
}

}  // namespace
}  // namespace collage
