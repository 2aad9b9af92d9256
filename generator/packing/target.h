#pragma once

#include <optional>
#include <span>

#include "geometry/distance_grid.h"
#include "geometry/solid.h"
#include "packing/voxel_grid.h"

namespace collage {

/// The space to fill, whatever it was made from. All lengths in world units.
class Target {
 public:
  virtual ~Target() = default;

  /// Box of the target's surface.
  [[nodiscard]] virtual Box box() const = 0;
  [[nodiscard]] virtual double volume() const = 0;
  /// Voxels over the box; see VoxelGrid.
  [[nodiscard]] virtual VoxelGrid voxels(int resolution, double jitter,
                                         std::uint64_t seed) const = 0;
  /// Distance from a point inside to the surface, never more than the true one; negative outside.
  [[nodiscard]] virtual double clearance(const dvec3& point) const = 0;
  /// The same of a point inside, cheaper; may be infinite where it is not below `limit`.
  [[nodiscard]] virtual double clearance_below(const dvec3& point, double limit) const = 0;
  /// The same for many points, faster where each is near the one before it.
  virtual void clearances(std::span<const dvec3> points, std::span<double> clearances) const;
  /// The distance to the surface, up to rounding; negative outside.
  [[nodiscard]] virtual double signed_clearance(const dvec3& point) const = 0;
  /// Unit vector from a point inside to the nearest point of the surface.
  [[nodiscard]] virtual dvec3 direction_to_surface(const dvec3& point) const = 0;
};

class MeshTarget : public Target {
 public:
  explicit MeshTarget(const Mesh& mesh);

  [[nodiscard]] const Solid& solid() const { return solid_; }
  [[nodiscard]] Box box() const override { return box_; }
  [[nodiscard]] double volume() const override { return solid_.volume(); }
  [[nodiscard]] VoxelGrid voxels(int resolution, double jitter, std::uint64_t seed) const override;
  [[nodiscard]] double clearance(const dvec3& point) const override;
  [[nodiscard]] double clearance_below(const dvec3& point, double limit) const override;
  void clearances(std::span<const dvec3> points, std::span<double> clearances) const override;
  [[nodiscard]] double signed_clearance(const dvec3& point) const override;
  [[nodiscard]] dvec3 direction_to_surface(const dvec3& point) const override;

 private:
  [[nodiscard]] double clearance(const dvec3& point, std::optional<std::uint32_t>& hint) const;

  Box box_;
  Solid solid_;
};

/// A target known by signed distances at voxel centres alone (Muhm 2011, V.1.1). Its voxels are the
/// grid's own and are not jittered, so that each clearance is the one in the file.
class GridTarget : public Target {
 public:
  explicit GridTarget(DistanceGrid grid) : grid_(std::move(grid)) {}

  [[nodiscard]] Box box() const override;
  [[nodiscard]] double volume() const override;
  [[nodiscard]] VoxelGrid voxels(int resolution, double jitter, std::uint64_t seed) const override;
  [[nodiscard]] double clearance(const dvec3& point) const override;
  [[nodiscard]] double clearance_below(const dvec3& point, double /*limit*/) const override {
    return clearance(point);
  }
  [[nodiscard]] double signed_clearance(const dvec3& point) const override;
  [[nodiscard]] dvec3 direction_to_surface(const dvec3& point) const override;

 private:
  [[nodiscard]] glm::ivec3 voxel_at(const dvec3& point) const;

  DistanceGrid grid_;
};

}  // namespace collage
