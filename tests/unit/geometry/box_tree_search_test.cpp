#include "geometry/box_tree_search.h"

#include <limits>

#include <gtest/gtest.h>

#include "geometry/boxes.h"
#include "support/meshes.h"

namespace collage {
namespace {

std::vector<Box> random_boxes(std::size_t count) {
  Rng rng(21, 0);
  std::vector<Box> boxes(count);
  for (Box& box : boxes) {
    box.include(test::random_point(rng, 1.0));
    box.include(box.min + 0.1 * (1.0 + test::random_point(rng, 1.0)));
  }
  return boxes;
}

/// The least squared distance to a box, and how many leaves were looked at for it.
std::pair<double, int> search(const BoxTree& tree, const dvec3& point, double limit) {
  double best = limit;
  int visits = 0;
  const auto bound = [&](const Box& box) { return squared_distance(box, point); };
  visit_lowest_first(tree, bound, limit, [&](const BoxTree::Node& leaf) {
    ++visits;
    best = std::min(best, bound(leaf.box));
    return best;
  });
  return {best, visits};
}

TEST(VisitLowestFirst, FindsTheLeastOfAllAndLooksAtFew) {
  constexpr double unbounded = std::numeric_limits<double>::infinity();
  for (const std::size_t count : {1U, 2U, 3U, 1000U}) {
    const std::vector<Box> boxes = random_boxes(count);
    const BoxTree tree(boxes);
    Rng rng(22, count);
    int visits = 0;
    for (int i = 0; i < 100; ++i) {
      const dvec3 point = test::random_point(rng, 1.5);
      double truth = unbounded;
      for (const Box& box : boxes) {
        truth = std::min(truth, squared_distance(box, point));
      }
      const auto [found, looked_at] = search(tree, point, unbounded);
      EXPECT_EQ(found, truth);
      visits += looked_at;
    }
    EXPECT_LE(visits, 100 * std::min<int>(static_cast<int>(count), 20));
  }
}

TEST(VisitLowestFirst, LooksAtNothingThatIsNotBelowTheLimit) {
  const BoxTree tree({Box{dvec3(1), dvec3(2)}});
  EXPECT_EQ(search(tree, dvec3(0), 3.0).second, 0);
  EXPECT_EQ(search(tree, dvec3(0), 3.001).second, 1);
  EXPECT_EQ(search(BoxTree({}), dvec3(0), 1.0).second, 0);
}

}  // namespace
}  // namespace collage
