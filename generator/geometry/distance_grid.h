#pragma once

#include <filesystem>
#include <vector>

#include <glm/glm.hpp>

#include "geometry/mesh.h"
#include "geometry/solid.h"

namespace collage {

/// Signed distances to a surface at the centres of cubic voxels: negative inside.
struct DistanceGrid {
  glm::ivec3 size{0};
  /// The corner of the first voxel.
  dvec3 origin{0.0};
  double voxel_side = 1.0;
  /// x runs fastest, then y, then z.
  std::vector<float> values;

  [[nodiscard]] dvec3 center(const glm::ivec3& voxel) const {
    return origin + (dvec3(voxel) + 0.5) * voxel_side;
  }
  [[nodiscard]] float at(const glm::ivec3& v) const {
    return values[(static_cast<std::size_t>(v.z) * size.y + v.y) * size.x + v.x];
  }
};

/// Reads the thesis's input (Muhm 2011, V.1.1): a text of numbers parted by white space, first the
/// voxels along x, y and z, then optionally `origin X Y Z` and `voxel SIDE` (0 0 0 and 1 without),
/// then one signed distance a voxel, x fastest. `#` starts a comment. The outermost voxels must lie
/// outside the surface; where they are negative the file counts inside as positive, as the thesis
/// does, and is turned over. Throws Error with the line of what is wrong.
DistanceGrid read_distance_grid(const std::filesystem::path& path);

/// Writes what read_distance_grid() reads, whole or not at all.
void write_distance_grid(const std::filesystem::path& path, const DistanceGrid& grid);

/// Samples a solid: `resolution` voxels on the longest side of `box`, with one more all round.
/// Runs on all threads; one closest-point query and one inside test a voxel.
DistanceGrid sample_distance_grid(const Solid& solid, const Box& box, int resolution);

}  // namespace collage
