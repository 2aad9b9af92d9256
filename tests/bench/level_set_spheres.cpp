#include "bench/level_set_spheres.h"

#ifdef COLLAGE_OPENVDB
#include <limits>

#include <openvdb/tools/MeshToVolume.h>
#include <openvdb/tools/VolumeToSpheres.h>

#include "geometry/mesh_check.h"
#endif

namespace collage::bench {

#ifdef COLLAGE_OPENVDB

std::vector<double> level_set_spheres(const Mesh& mesh, int voxels, int count) {
  openvdb::initialize();
  std::vector<openvdb::Vec3s> points;
  for (const dvec3& p : mesh.positions) {
    points.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z));
  }
  std::vector<openvdb::Vec3I> triangles;
  for (const uvec3& t : mesh.triangles) {
    triangles.emplace_back(t.x, t.y, t.z);
  }
  const double voxel_side = bounding_box(mesh).longest_side() / voxels;
  const auto transform = openvdb::math::Transform::createLinearTransform(voxel_side);
  const openvdb::FloatGrid::Ptr grid =
      openvdb::tools::meshToLevelSet<openvdb::FloatGrid>(*transform, points, triangles);
  std::vector<openvdb::Vec4s> spheres;
  constexpr float smallest_voxels = 0.3F;
  constexpr int candidates = 100'000;
  openvdb::tools::fillWithSpheres(*grid, spheres, openvdb::Vec2i(count, count), false,
                                  smallest_voxels, std::numeric_limits<float>::max(), 0.0F,
                                  candidates);
  std::vector<double> radii;
  for (const openvdb::Vec4s& sphere : spheres) {
    radii.push_back(sphere[3]);
  }
  return radii;
}

#else

std::vector<double> level_set_spheres(const Mesh& /*mesh*/, int /*voxels*/, int /*count*/) {
  return {};
}

#endif

}  // namespace collage::bench
