#include "packing/update.h"

#include <limits>

#include <gtest/gtest.h>

#include "support/exact_packer.h"
#include "support/meshes.h"

namespace collage {
namespace {

/// A target and instances of one element, placed without turning them to the nearest surface.
struct Sculpture {
  Sculpture(const Mesh& target_mesh, const Mesh& mesh, int resolution, double jitter = 0.5)
      : target(target_mesh),
        element(mesh),
        surfaces(target, {&element}),
        field(target, target.voxels(resolution, jitter, 3), status) {}

  /// The largest hole, asked exactly.
  ClearanceField::Peak peak() {
    for (;;) {
      const ClearanceField::Peak peak = field.peak().value();
      if (field.block(peak.block).nearest[peak.slot].is_exact()) {
        return peak;
      }
      field.set_block_maximum(peak.block, make_exact(field, surfaces, peak, 0.0F));
    }
  }
  Hole hole() {
    const ClearanceField::Peak top = peak();
    return {field.sample_point(top), top.upper, field.block(top.block).nearest[top.slot].id()};
  }
  /// Adds an instance to the surfaces, not to the field.
  void place(const Hole& hole, const glm::dquat& rotation) {
    Instance instance;
    instance.scale = hole.clearance / element.size();
    instance.rotation = glm::normalize(rotation);
    instance.translation = hole.center - instance.rotation * (instance.scale * element.center());
    surfaces.add(instance);
  }
  void update_field(const Hole& hole, float useless = 0.0F) {
    update(field, surfaces, static_cast<SurfaceId>(surfaces.instances().size()), hole, useless, 0.0,
           done);
  }

  Status status;
  MeshTarget target;
  Element element;
  Surfaces surfaces;
  ClearanceField field;
  Update done;
};

template <class Visit>
void for_each_voxel(ClearanceField& field, const Visit& visit) {
  for (std::size_t b = 0; b < field.grid().block_count(); ++b) {
    for (std::size_t slot = 0; slot < VoxelGrid::block_voxels; ++slot) {
      visit(field.block(b), slot);
    }
  }
}

/// Every pair of bounds against the exact distances to all surfaces, in double and without
/// hierarchy. Returns how many clearances are not known exactly.
std::size_t expect_true_bounds(Sculpture& s, const Mesh& target_mesh, const Mesh& element,
                               float useless) {
  const auto side = static_cast<float>(s.field.grid().voxel_side);
  std::size_t free = 0;
  std::size_t vague = 0;
  for_each_voxel(s.field, [&](const ClearanceField::Block& block, std::size_t slot) {
    const float upper = block.upper[slot];
    if (upper < 0.0F) {
      return;
    }
    ++free;
    vague += block.nearest[slot].is_exact() ? 0 : 1;
    const dvec3 p = s.field.grid().sample_point(block.first_voxel + VoxelGrid::local_at(slot));
    double truth = std::numeric_limits<double>::infinity();
    const auto consider = [&](const Mesh& mesh, const Instance& placed) {
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const dvec3 closest =
            closest_point_on_triangle(p, placed.world_from_element(mesh.corner(t, 0)),
                                      placed.world_from_element(mesh.corner(t, 1)),
                                      placed.world_from_element(mesh.corner(t, 2)));
        truth = std::min(truth, glm::distance(p, closest));
      }
    };
    consider(target_mesh, Instance{});
    for (const Instance& instance : s.surfaces.instances()) {
      consider(element, instance);
    }
    ASSERT_GE(static_cast<double>(upper), truth - 1e-5);
    if (upper < useless) {
      return;
    }
    ASSERT_LE(static_cast<double>(block.nearest[slot].lower(upper, side)), truth);
    if (block.nearest[slot].is_exact()) {
      ASSERT_LE(static_cast<double>(upper), truth);
    }
  });
  EXPECT_GT(free, 100U);
  return vague;
}

TEST(Update, BoundsHoldTheTruthAndNoExactClearanceIsAboveIt) {
  const Mesh target_mesh = test::blob_mesh(1.0, 0.2, 10);
  const Mesh mesh = test::torus_mesh(1.0, 0.3, 10, 6);
  for (const float useless : {0.0F, 0.1F}) {
    Sculpture s(target_mesh, mesh, 20);
    std::size_t vague = 0;
    for (int i = 0; i < 4; ++i) {
      const Hole hole = s.hole();
      s.place(hole, {1.0, 0.3 * i, 0.2, -0.5 * i});
      s.update_field(hole, useless);
      commit(s.field, s.done);
      vague += expect_true_bounds(s, target_mesh, mesh, useless);
    }
    EXPECT_GT(vague, 100U);
  }
}

TEST(Update, FlagsExactlyTheVoxelsInside) {
  Sculpture s(test::box_mesh(dvec3(-1), dvec3(1)), test::blob_mesh(1.0, 0.0, 24), 40, 0.0);
  s.surfaces.add({0, 0.5, {1.0, 0.0, 0.0, 0.0}, dvec3(0.0)});
  s.update_field({dvec3(0.0), 1.0, target_surface});
  const double voxel = 2.0 / 40.0;
  const double volume = static_cast<double>(s.done.voxels_flagged) * voxel * voxel * voxel;
  EXPECT_NEAR(volume / (0.125 * s.element.solid().volume()), 1.0, 0.02);
}

TEST(Update, MaximaAreThoseOfTheVoxels) {
  Sculpture s(test::blob_mesh(1.0, 0.2, 10), test::torus_mesh(1.0, 0.3, 10, 6), 30);
  for (int i = 0; i < 5; ++i) {
    const Hole hole = s.hole();
    s.place(hole, {1.0, 0.0, 0.0, 0.0});
    s.update_field(hole);
    commit(s.field, s.done);
    float largest = -1.0F;
    for (std::size_t b = 0; b < s.field.grid().block_count(); ++b) {
      EXPECT_EQ(s.field.scan_block(b), s.field.block_maximum(b));
      largest = std::max(largest, s.field.scan_block(b));
    }
    EXPECT_EQ(s.field.peak()->upper, largest);
  }
}

TEST(Update, UndoingLeavesEveryVoxelAsItWas) {
  for (const float useless : {0.0F, 0.15F}) {
    Sculpture s(test::blob_mesh(1.0, 0.2, 10), test::torus_mesh(1.0, 0.3, 10, 6), 30);
    for (int i = 0; i < 6; ++i) {
      const Hole hole = s.hole();
      std::vector<std::pair<float, NearestSurface>> before;
      const auto changed = [&] {
        std::size_t count = 0;
        std::size_t next = 0;
        for_each_voxel(s.field, [&](const ClearanceField::Block& block, std::size_t slot) {
          const auto& [upper, nearest] = before[next++];
          count += upper == block.upper[slot] && nearest == block.nearest[slot] ? 0 : 1;
        });
        return count;
      };
      for_each_voxel(s.field, [&](const ClearanceField::Block& block, std::size_t slot) {
        before.emplace_back(block.upper[slot], block.nearest[slot]);
      });
      s.place(hole, {1.0, 0.1 * i, 0.0, 0.0});
      s.update_field(hole, useless);
      EXPECT_GT(changed(), 0U);
      undo(s.field, s.done);
      EXPECT_EQ(changed(), 0U);
      s.update_field(hole, useless);
      commit(s.field, s.done);
    }
  }
}

/// Returns how many clearances of the first had not been traced to one surface.
int expect_same_once_exact(Sculpture& fast, Sculpture& slow, float useless = 0.0F) {
  int open = 0;
  for (std::size_t b = 0; b < fast.field.grid().block_count(); ++b) {
    for (std::size_t slot = 0; slot < VoxelGrid::block_voxels; ++slot) {
      if (fast.field.block(b).upper[slot] >= useless) {
        open += fast.field.block(b).nearest[slot].id() == several_surfaces ? 1 : 0;
        make_exact(fast.field, fast.surfaces, {b, slot, 0.0F}, useless);
      }
      const float upper = fast.field.block(b).upper[slot];
      if (upper >= 0.0F && upper < useless) {
        EXPECT_LE(slow.field.block(b).upper[slot], upper);
        continue;
      }
      if (upper >= 0.0F) {
        EXPECT_TRUE(fast.field.block(b).nearest[slot].is_exact());
        EXPECT_EQ(fast.field.block(b).nearest[slot].id(), slow.field.block(b).nearest[slot].id());
      }
      EXPECT_EQ(fast.field.block(b).upper[slot], slow.field.block(b).upper[slot]);
    }
  }
  return open;
}

/// After every update each clearance, once asked exactly, is the one of the slow twin.
TEST(Update, OnceExactIsTheSameAsItsSlowTwinToTheLastBit) {
  const Mesh target_mesh = test::blob_mesh(1.0, 0.2, 16);
  const Mesh mesh = test::torus_mesh(1.0, 0.3, 16, 8);
  for (const float useless : {0.0F, 0.1F}) {
    Sculpture fast(target_mesh, mesh, 30);
    Sculpture slow(target_mesh, mesh, 30);
    for (int i = 0; i < 20; ++i) {
      const Hole hole = fast.hole();
      ASSERT_EQ(hole.clearance, slow.hole().clearance);
      for (Sculpture* s : {&fast, &slow}) {
        s->place(hole, {1.0, 0.3 * i, 0.2, -0.5 * i});
      }
      fast.update_field(hole, useless);
      commit(fast.field, fast.done);
      const std::size_t flagged =
          test::exact_update(slow.field, slow.surfaces, static_cast<SurfaceId>(i + 1), hole);
      EXPECT_EQ(fast.done.voxels_flagged, flagged);
    }
    EXPECT_GT(expect_same_once_exact(fast, slow, useless), 100);
  }
}

/// Where float is at its worst: instances far smaller than a voxel, and far from the origin.
TEST(Update, TinyInstancesAndFarOnesAreTheSameAsInItsSlowTwin) {
  for (const double offset : {0.0, 3e5}) {
    for (const double share : {1.0, 0.1, 0.003}) {
      const Mesh target_mesh = test::box_mesh(dvec3(offset - 1.0), dvec3(offset + 1.0));
      const Mesh mesh = test::torus_mesh(1.0, 0.3, 16, 8);
      Sculpture fast(target_mesh, mesh, 20);
      Sculpture slow(target_mesh, mesh, 20);
      Rng rng(8, 0);
      for (int i = 0; i < 10; ++i) {
        Hole hole = fast.hole();
        hole.clearance *= static_cast<float>(share);
        hole.center += test::random_point(rng, 0.5);
        for (Sculpture* s : {&fast, &slow}) {
          s->place(hole, {1.0, 0.3 * i, 0.2, -0.5 * i});
        }
        hole.clearance = 2.0;
        fast.update_field(hole);
        commit(fast.field, fast.done);
        const std::size_t flagged =
            test::exact_update(slow.field, slow.surfaces, static_cast<SurfaceId>(i + 1), hole);
        EXPECT_EQ(fast.done.voxels_flagged, flagged);
      }
      expect_same_once_exact(fast, slow);
    }
  }
}

}  // namespace
}  // namespace collage
