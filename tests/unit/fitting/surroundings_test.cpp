#include "fitting/surroundings.h"

#include <gtest/gtest.h>

#include "fitting/free_space.h"
#include "packing/orientation.h"
#include "support/meshes.h"

namespace collage {
namespace {

struct Neighbours {
  Mesh mesh = test::torus_mesh(1.0, 0.3, 24, 12);
  Element element{mesh};
  ShapedElement shape{mesh, element, measure_shape(mesh, element)};
  std::vector<Pose> poses;

  explicit Neighbours(int count) {
    Rng rng(1, 2);
    for (int i = 0; i < count; ++i) {
      const dvec3 axis = glm::normalize(test::random_point(rng, 1.0));
      poses.push_back({test::random_point(rng, 0.6), orientation({0.0, 0.0, 1.0}, axis, 1.0),
                       0.2 + 0.4 * rng.uniform()});
    }
  }
  /// The least of all lattices, each asked.
  [[nodiscard]] double distance(const dvec3& point) const {
    double nearest = 1e30;
    for (const Pose& pose : poses) {
      const dvec3 unit = glm::conjugate(pose.rotation) * (point - pose.center) / pose.radius;
      const glm::vec3 steps(shape.distances().steps(unit));
      const double here = shape.distances().holds(steps) ? double{shape.distances().value(steps)}
                                                         : glm::length(unit) - 1.0;
      nearest = std::min(nearest, here * pose.radius);
    }
    return nearest;
  }
};

/// In places of which some are out of the reach asked for, held against all lattices.
void expect_nearest_of_all(const Neighbours& all, const DistanceField* target) {
  const auto distance = [&](const dvec3& point) {
    const double nearest = all.distance(point);
    return target == nullptr
               ? nearest
               : std::min(nearest, double{target->value(glm::vec3(target->steps(point)))});
  };
  Surroundings surroundings;
  surroundings.reset(dvec3(0.1), 0.9, target);
  for (const Pose& pose : all.poses) {
    surroundings.add(all.shape, pose);
  }
  Rng rng(3, 4);
  int falling = 0;
  for (int i = 0; i < 4000; ++i) {
    const dvec3 point = test::random_point(rng, 1.2);
    glm::vec3 direction;
    auto nearest = static_cast<std::uint32_t>(i % 20);  // some guesses are wrong, some impossible
    EXPECT_NEAR(surroundings.value(surroundings.from_origin(point), direction, nearest),
                distance(point), 1e-5);
    EXPECT_NEAR(glm::length(direction), 1.0, 1e-4);
    const dvec3 farther = point + 1e-3 * dvec3(direction);
    falling += distance(farther) < distance(point) - 1e-5 ? 1 : 0;
  }
  EXPECT_LT(falling,
            40);  // only where the step comes nearer to another neighbour, or on its lattice
}

TEST(Surroundings, AreAsNearAsTheNearestOfAllNeighbours) {
  expect_nearest_of_all(Neighbours(3), nullptr);
  expect_nearest_of_all(Neighbours(16), nullptr);
}

TEST(Surroundings, AreAsNearAsTheTargetWhereThatIsNearer) {
  const Mesh mesh = test::box_mesh(dvec3(-1.0), dvec3(1.1));
  const MeshTarget target(mesh);
  Status status;
  const FreeSpace space(target, 32, status);
  expect_nearest_of_all(Neighbours(16), &space.distances());
}

TEST(DistanceMinima, AreBelowTheField) {
  const Neighbours all(1);
  const DistanceField& field = all.shape.distances();
  Rng rng(5, 6);
  for (int i = 0; i < 5000; ++i) {
    const glm::vec3 steps(dvec3(field.size() - 1) * (0.5 + test::random_point(rng, 0.4999)));
    EXPECT_LE(all.shape.distance_minima().below(steps), field.value(steps));
  }
}

}  // namespace
}  // namespace collage
