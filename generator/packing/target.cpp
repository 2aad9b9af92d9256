#include "packing/target.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace collage {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

dvec3 unit_vector(const dvec3& v) {
  const double length = glm::length(v);
  return length > 0.0 ? v / length : dvec3(0.0, 1.0, 0.0);
}

}  // namespace

void Target::clearances(std::span<const dvec3> points, std::span<double> clearances) const {
  std::transform(points.begin(), points.end(), clearances.begin(),
                 [this](const dvec3& point) { return clearance(point); });
}

MeshTarget::MeshTarget(const Mesh& mesh)
    : box_(bounding_box(mesh)), solid_(mesh, box_.center(), 0.5 * glm::length(box_.extent())) {}

VoxelGrid MeshTarget::voxels(int resolution, double jitter, std::uint64_t seed) const {
  VoxelGrid grid;
  grid.voxel_side = box_.longest_side() / resolution;
  // One voxel of padding on each side; the tolerance keeps the longest side at `resolution`.
  grid.size = glm::ivec3(glm::ceil(box_.extent() / grid.voxel_side - 1e-9)) + 2;
  grid.origin = box_.center() - 0.5 * grid.voxel_side * dvec3(grid.size);
  grid.jitter = jitter;
  grid.seed = seed;
  return grid;
}

double MeshTarget::clearance(const dvec3& point) const {
  std::optional<std::uint32_t> hint;
  return clearance(point, hint);
}

/// `hint` is a triangle that may be near, and becomes the nearest.
double MeshTarget::clearance(const dvec3& point, std::optional<std::uint32_t>& hint) const {
  const dvec3 unit = solid_.unit_from_mesh(point);
  if (!solid_.inside(unit)) {
    return -1.0;
  }
  const auto closest = solid_.surface().find(unit, unbounded, hint);
  hint = closest->triangle;
  return std::max(0.0, closest->distance - ClosestPointIndex::error(unit)) * solid_.radius();
}

double MeshTarget::clearance_below(const dvec3& point, double limit) const {
  const dvec3 unit = solid_.unit_from_mesh(point);
  const double error = ClosestPointIndex::error(unit);
  const auto closest = solid_.surface().find(unit, limit / solid_.radius() + error);
  return closest ? std::max(0.0, closest->distance - error) * solid_.radius() : unbounded;
}

void MeshTarget::clearances(std::span<const dvec3> points, std::span<double> clearances) const {
  std::optional<std::uint32_t> hint;
  for (std::size_t i = 0; i < points.size(); ++i) {
    clearances[i] = clearance(points[i], hint);
  }
}

double MeshTarget::signed_clearance(const dvec3& point) const {
  const dvec3 unit = solid_.unit_from_mesh(point);
  const double distance = solid_.surface().find(unit, unbounded)->distance * solid_.radius();
  return solid_.inside(unit) ? distance : -distance;
}

dvec3 MeshTarget::direction_to_surface(const dvec3& point) const {
  const dvec3 unit = solid_.unit_from_mesh(point);
  return unit_vector(solid_.surface().find(unit, unbounded)->point - unit);
}

Box GridTarget::box() const {
  Box box;
  glm::ivec3 v;
  for (v.z = 0; v.z < grid_.size.z; ++v.z) {
    for (v.y = 0; v.y < grid_.size.y; ++v.y) {
      for (v.x = 0; v.x < grid_.size.x; ++v.x) {
        if (grid_.at(v) < 0.0F) {
          box.include(grid_.center(v) - 0.5 * grid_.voxel_side);
          box.include(grid_.center(v) + 0.5 * grid_.voxel_side);
        }
      }
    }
  }
  return box;
}

double GridTarget::volume() const {
  const double side = grid_.voxel_side;
  double voxels = 0.0;
  for (const float distance : grid_.values) {
    voxels += std::clamp(0.5 - distance / side, 0.0, 1.0);  // the surface cuts across near voxels
  }
  return voxels * side * side * side;
}

VoxelGrid GridTarget::voxels(int /*resolution*/, double /*jitter*/, std::uint64_t seed) const {
  return {grid_.size, grid_.origin, grid_.voxel_side, 0.0, seed};
}

glm::ivec3 GridTarget::voxel_at(const dvec3& point) const {
  const glm::ivec3 voxel(glm::floor((point - grid_.origin) / grid_.voxel_side));
  return glm::clamp(voxel, glm::ivec3(0), grid_.size - 1);
}

double GridTarget::clearance(const dvec3& point) const {
  const glm::ivec3 voxel = voxel_at(point);
  return -grid_.at(voxel) - glm::distance(point, grid_.center(voxel));
}

double GridTarget::signed_clearance(const dvec3& point) const { return -grid_.at(voxel_at(point)); }

dvec3 GridTarget::direction_to_surface(const dvec3& point) const {
  const glm::ivec3 voxel = voxel_at(point);
  dvec3 gradient(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    glm::ivec3 step(0);
    step[axis] = 1;
    const glm::ivec3 next = glm::min(voxel + step, grid_.size - 1);
    const glm::ivec3 previous = glm::max(voxel - step, glm::ivec3(0));
    gradient[axis] = grid_.at(next) - grid_.at(previous);
  }
  return unit_vector(gradient);  // the signed distance grows towards the surface and beyond
}

}  // namespace collage
