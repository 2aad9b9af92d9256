#pragma once

#include <vector>

#include "geometry/mesh.h"

namespace collage {

/// A cube from `low` to `low` + `side`, twelve triangles facing outwards.
inline Mesh make_cube(const dvec3& low = dvec3(0.0), double side = 1.0) {
  Mesh mesh;
  for (unsigned i = 0; i < 8; ++i) {
    mesh.positions.push_back(low + side * dvec3(i & 1U, i >> 1U & 1U, i >> 2U & 1U));
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

inline void append(Mesh& mesh, const Mesh& other) {
  const auto offset = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  for (const uvec3& t : other.triangles) {
    mesh.triangles.push_back(t + uvec3(offset));
  }
}

inline Mesh reversed(Mesh mesh) {
  reverse_orientation(mesh);
  return mesh;
}

}  // namespace collage
