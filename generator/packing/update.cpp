#include "packing/update.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "geometry/boxes.h"
#include "packing/block_update.h"

namespace collage {
namespace {

/// A footprint of more blocks than this is worth being shared among threads.
constexpr std::size_t blocks_on_one_thread = 64;

}  // namespace

BlockRange footprint(const VoxelGrid& grid, const Hole& hole, double margin) {
  const auto block_of = [&](const dvec3& point) {
    const dvec3 voxel = glm::floor((point - grid.origin) / grid.voxel_side);
    return glm::clamp(voxel, dvec3(0.0), dvec3(grid.size - 1));
  };
  const double reach = 2.0 * hole.clearance + margin;
  return {glm::ivec3(block_of(hole.center - reach)) / VoxelGrid::block_side,
          glm::ivec3(block_of(hole.center + reach)) / VoxelGrid::block_side + 1};
}

void update(ClearanceField& field, const Surfaces& surfaces, SurfaceId id, const Hole& hole,
            float useless, double margin, Update& done) {
  const VoxelGrid& grid = field.grid();
  const PlacedElement placed = surfaces.placed(id, grid.voxel_side);
  done.id = id;
  done.voxels_flagged = 0;
  done.before.clear();
  done.maxima.clear();

  const BlockRange range = footprint(grid, hole, margin);
  const double block_side = VoxelGrid::block_side * grid.voxel_side;
  glm::ivec3 at;
  for (at.z = range.first.z; at.z < range.last.z; ++at.z) {
    for (at.y = range.first.y; at.y < range.last.y; ++at.y) {
      for (at.x = range.first.x; at.x < range.last.x; ++at.x) {
        const std::size_t index = grid.block_index(at);
        const float maximum = field.block_maximum(index);
        if (maximum < 0.0F) {
          continue;
        }
        const dvec3 corner = grid.origin + dvec3(at) * block_side;
        const bool has_holes = maximum >= useless;
        const double reach = placed.radius() * (1.0 + 1e-5) + (has_holes ? maximum + margin : 0.0);
        if (squared_distance({corner, corner + block_side}, placed.center()) < reach * reach) {
          done.maxima.push_back({index, maximum, has_holes && margin > 0.0});
        }
      }
    }
  }
  BlockUpdate work(field, id, placed, useless);
  if (done.maxima.size() <= blocks_on_one_thread) {
    for (Update::Maximum& maximum : done.maxima) {
      done.voxels_flagged += work.run(maximum, done.before);
    }
    return;
  }
  const std::size_t blocks = done.maxima.size();
  done.shares.resize(std::max(done.shares.size(), blocks));
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks), [&](const auto& some) {
    BlockUpdate mine = work;
    for (std::size_t b = some.begin(); b < some.end(); ++b) {
      Update::Share& share = done.shares[b];
      share.before.clear();
      share.voxels_flagged = mine.run(done.maxima[b], share.before);
    }
  });
  for (std::size_t b = 0; b < blocks; ++b) {
    const Update::Share& share = done.shares[b];
    done.voxels_flagged += share.voxels_flagged;
    done.before.insert(done.before.end(), share.before.begin(), share.before.end());
  }
}

void commit(ClearanceField& field, const Update& done) {
  for (const Update::Maximum& maximum : done.maxima) {
    field.set_block_maximum(maximum.block, maximum.upper);
    if (maximum.is_near) {
      field.add_neighbour(maximum.block, done.id);
    }
  }
}

void undo(ClearanceField& field, const Update& done) {
  for (auto voxel = done.before.rbegin(); voxel != done.before.rend(); ++voxel) {
    const ClearanceField::Block block = field.block(voxel->block);
    block.upper[voxel->slot] = voxel->upper;
    block.nearest[voxel->slot] = voxel->nearest;
  }
}

float make_exact(ClearanceField& field, const Surfaces& surfaces, const ClearanceField::Peak& peak,
                 float useless) {
  const ClearanceField::Block block = field.block(peak.block);
  NearestSurface& nearest = block.nearest[peak.slot];
  float& upper = block.upper[peak.slot];
  if (upper >= useless && nearest.is_exact()) {
    return field.scan_block(peak.block);
  }
  const dvec3 point = field.sample_point(peak);
  Nearest found;
  const float near_enough = upper < useless ? 0.0F : useless;
  const auto consider = [&](SurfaceId id) {
    if (found.clearance >= near_enough) {
      surfaces.consider(id, point, found, near_enough);
    }
  };
  if (upper < useless) {
    consider(target_surface);
    for (std::size_t i = 1; i <= surfaces.instances().size(); ++i) {
      consider(static_cast<SurfaceId>(i));
    }
  } else if (nearest.id() == several_surfaces) {
    found.clearance = upper;
    // First the one that is likely to rule the others out.
    SurfaceId likeliest = target_surface;
    float least = field.least_from_target(peak.block);
    field.for_each_neighbour(peak.block, [&](SurfaceId id) {
      const float bound = surfaces.least_clearance(id, point, upper);
      if (bound < least) {
        likeliest = id;
        least = bound;
      }
    });
    consider(likeliest);
    field.for_each_neighbour(peak.block, consider);
    if (field.least_from_target(peak.block) <= found.clearance) {
      consider(target_surface);
    }
  } else {
    found.clearance = upper;
    consider(nearest.id());
  }
  nearest = NearestSurface(found.id);
  upper = found.clearance;
  return field.scan_block(peak.block);
}

}  // namespace collage
