#pragma once

#include <vector>

#include "packing/clearance_field.h"
#include "packing/surfaces.h"

namespace collage {

/// Blocks of voxels from `first` to one before `last`.
struct BlockRange {
  glm::ivec3 first{0};
  glm::ivec3 last{0};
};

inline bool ranges_meet(const BlockRange& a, const BlockRange& b) {
  return glm::all(glm::lessThan(a.first, b.last)) && glm::all(glm::lessThan(b.first, a.last));
}

/// The blocks whose voxels a new instance in a hole can change, and those less than `margin`
/// farther off. No clearance exceeds the hole's, so that no voxel farther from the hole's centre
/// than twice that changes.
BlockRange footprint(const VoxelGrid& grid, const Hole& hole, double margin = 0.0);

/// What an update did, and how it was before. Updates of disjoint footprints may run at the same
/// time. Its memory is kept for the next update.
struct Update {
  /// A voxel as it was.
  struct Voxel {
    /// Of the block and in it.
    std::uint32_t block;
    std::uint32_t slot;
    float upper;
    NearestSurface nearest;
  };
  /// The largest upper bound of a block afterwards, and whether the instance may be the nearest
  /// surface to some of its voxels.
  struct Maximum {
    std::size_t block;
    float upper;
    bool is_near;
  };
  SurfaceId id = target_surface;
  std::size_t voxels_flagged = 0;
  std::vector<Voxel> before;
  std::vector<Maximum> maxima;

  /// Of one of many blocks, while threads share them.
  struct Share {
    std::size_t voxels_flagged = 0;
    std::vector<Voxel> before;
  };
  std::vector<Share> shares;
};

/// Accounts for instance `id` (Muhm 2011, Fig. 12), which fills `hole`: voxels inside it are
/// flagged, every other voxel to which it is now the nearest surface gets its distance. The
/// distance is a pair of bounds from the element's grids; where these do not tell which surface is
/// the nearer, that is left to make_exact(), should it ever matter. A voxel with an upper bound
/// below `useless`, too little ever to be a hole, keeps that bound and is looked at only where it
/// may be inside; what else is stored there means nothing. The blocks' maxima are left to commit().
/// With `margin`, the instance becomes a neighbour of all blocks for whose holes it is near enough
/// to matter to points up to half of that from their centres.
/// Costs about 30 ns for each voxel nearer to the instance's sphere than its clearance.
void update(ClearanceField& field, const Surfaces& surfaces, SurfaceId id, const Hole& hole,
            float useless, double margin, Update& done);

/// Makes the field's maxima and neighbours those after the update.
void commit(ClearanceField& field, const Update& done);
/// Makes the voxels what they were before.
void undo(ClearanceField& field, const Update& done);

/// Finds the exact clearance of a voxel, from its nearest surface, or where that is not known from
/// its block's neighbours, or where it is useless from all. One that turns out to be below
/// `useless` may come out larger, but still below that.
/// Returns the block's largest upper bound afterwards.
float make_exact(ClearanceField& field, const Surfaces& surfaces, const ClearanceField::Peak& peak,
                 float useless);

}  // namespace collage
