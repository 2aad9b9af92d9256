#include "audit/contacts.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "audit/surfaces_within.h"
#include "support/meshes.h"

namespace collage {
namespace {

Contacts contacts_of(const Mesh& element, const std::vector<Instance>& instances, double gap) {
  const std::vector<const Mesh*> elements{&element};
  Status status;
  return *contacts(InstanceIndex(elements, instances), gap, status);
}

/// The slow twin: all pairs are tested, then clusters are flooded.
Contacts by_brute_force(const Mesh& element, const std::vector<Instance>& instances, double gap) {
  const SurfaceTree tree(element);
  const std::size_t n = instances.size();
  std::vector<char> seen(n, 0);
  std::vector<std::size_t> sizes;
  for (std::size_t first = 0; first < n; ++first) {
    std::vector<std::size_t> cluster;
    if (seen[first] == 0) {
      cluster.push_back(first);
      seen[first] = 1;
    }
    for (std::size_t k = 0; k < cluster.size(); ++k) {
      for (std::size_t j = 0; j < n; ++j) {
        if (seen[j] == 0 && surfaces_within(gap, tree, instances[cluster[k]], tree, instances[j])) {
          cluster.push_back(j);
          seen[j] = 1;
        }
      }
    }
    if (!cluster.empty()) {
      sizes.push_back(cluster.size());
    }
  }
  const auto of_all = [&](auto count) {
    return static_cast<double>(count) / static_cast<double>(n);
  };
  return {gap, sizes.size(), of_all(std::count(sizes.begin(), sizes.end(), 1U)),
          of_all(*std::max_element(sizes.begin(), sizes.end()))};
}

TEST(Contacts, AgreeWithBruteForce) {
  const Mesh ring = test::torus_mesh(1.0, 0.3, 10, 6);
  Rng rng(91, 0);
  std::vector<Instance> instances(2500);  // more than a batch
  for (Instance& instance : instances) {
    instance.scale = 0.01 + 0.02 * rng.uniform();
    instance.translation = test::random_point(rng, 0.7);
  }
  for (const double gap : {0.0, 0.005, 0.02, 0.08}) {
    const Contacts fast = contacts_of(ring, instances, gap);
    const Contacts slow = by_brute_force(ring, instances, gap);
    EXPECT_EQ(fast.gap, gap);
    EXPECT_EQ(fast.clusters, slow.clusters);
    EXPECT_EQ(fast.floating_share, slow.floating_share);
    EXPECT_EQ(fast.largest_cluster_share, slow.largest_cluster_share);
  }
}

TEST(Contacts, OfARowOfCubesAndOneApart) {
  const Mesh cube = test::box_mesh(dvec3(0), dvec3(1));
  std::vector<Instance> instances(5);
  for (std::size_t i = 0; i < 4; ++i) {
    instances[i].translation.x = 1.1 * static_cast<double>(i);
  }
  instances[4].translation.x = -7.0;
  const Contacts near = contacts_of(cube, instances, 0.11);
  EXPECT_EQ(near.clusters, 2U);
  EXPECT_EQ(near.floating_share, 0.2);
  EXPECT_EQ(near.largest_cluster_share, 0.8);
  const Contacts far = contacts_of(cube, instances, 0.09);
  EXPECT_EQ(far.clusters, 5U);
  EXPECT_EQ(far.floating_share, 1.0);
  EXPECT_EQ(far.largest_cluster_share, 0.2);
}

TEST(Contacts, OfNothingAreNothing) {
  Status status;
  EXPECT_FALSE(contacts(InstanceIndex({}, {}), 1.0, status));
}

}  // namespace
}  // namespace collage
