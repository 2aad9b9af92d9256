#include "packing/clearance_field.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

namespace collage {
namespace {

/// Every voxel but the outermost as deep inside as any other.
DistanceGrid level_grid(const glm::ivec3& size) {
  DistanceGrid grid;
  grid.size = size;
  for (int z = 0; z < size.z; ++z) {
    for (int y = 0; y < size.y; ++y) {
      for (int x = 0; x < size.x; ++x) {
        const glm::ivec3 voxel(x, y, z);
        const bool is_inside = glm::all(glm::greaterThan(voxel, glm::ivec3(0))) &&
                               glm::all(glm::lessThan(voxel, size - 1));
        grid.values.push_back(is_inside ? -1.0F : 1.0F);
      }
    }
  }
  return grid;
}

TEST(VoxelGrid, EveryBlockHasItsIndex) {
  const VoxelGrid grid{{21, 9, 30}};
  EXPECT_EQ(grid.block_count(), 6U * 4U * 8U);
  for (std::size_t index = 0; index < grid.block_count(); ++index) {
    EXPECT_EQ(grid.block_index(grid.block_at(index)), index);
  }
}

TEST(ClearanceField, TiesGoToTheFirstGroupThenToTheLeastZThenYThenX) {
  const GridTarget target(level_grid({19, 13, 10}));
  Status status;
  ClearanceField field(target, target.voxels(0, 0.0, 0), status);
  using Place = std::tuple<int, int, int, int, int, int>;
  std::optional<Place> last;
  std::size_t peaks = 0;
  while (const auto peak = field.peak()) {
    const glm::ivec3 voxel = field.grid().block_at(peak->block) * VoxelGrid::block_side +
                             VoxelGrid::local_at(peak->slot);
    const glm::ivec3 group = voxel / VoxelGrid::group_side;
    const Place place{group.z, group.y, group.x, voxel.z, voxel.y, voxel.x};
    EXPECT_TRUE(!last || *last < place);
    last = place;
    field.close(*peak);
    ++peaks;
  }
  EXPECT_EQ(peaks, field.voxels_inside());
  EXPECT_EQ(peaks, 17U * 11U * 8U);
}

TEST(ClearanceField, ListsTheNeighboursOfEachBlock) {
  const GridTarget target(level_grid({9, 9, 9}));
  Status status;
  ClearanceField field(target, target.voxels(0, 0.0, 0), status);
  std::array<std::set<SurfaceId>, 3> added;
  for (SurfaceId id = 1; id <= 100; ++id) {
    for (std::size_t block = 0; block < added.size(); ++block) {
      if (id % (block + 1) == 0) {
        field.add_neighbour(block, id);
        added[block].insert(id);
      }
    }
  }
  for (std::size_t block = 0; block < added.size(); ++block) {
    std::multiset<SurfaceId> listed;
    field.for_each_neighbour(block, [&](SurfaceId id) { listed.insert(id); });
    EXPECT_TRUE(std::ranges::equal(listed, added[block]));
  }
}

TEST(ClearanceField, KnowsTheLeastClearanceOfEachBlock) {
  DistanceGrid grid = level_grid({9, 9, 9});
  Rng rng(7, 0);
  for (float& value : grid.values) {
    value *= static_cast<float>(1.0 + rng.uniform());
  }
  const GridTarget target(grid);
  Status status;
  ClearanceField field(target, target.voxels(0, 0.0, 0), status);
  for (std::size_t b = 0; b < field.grid().block_count(); ++b) {
    const float* upper = field.block(b).upper;
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t slot = 0; slot < VoxelGrid::block_voxels; ++slot) {
      least = upper[slot] < 0.0F ? least : std::min(least, upper[slot]);
    }
    EXPECT_EQ(field.least_from_target(b), least);
  }
}

}  // namespace
}  // namespace collage
