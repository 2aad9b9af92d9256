#pragma once

#include <cmath>

#include <glm/gtc/constants.hpp>

#include "base/rng.h"
#include "geometry/mesh.h"

namespace collage::test {

/// A closed box, 12 triangles, outward.
inline Mesh box_mesh(const dvec3& min, const dvec3& max) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.positions.emplace_back(i & 1 ? max.x : min.x, i & 2 ? max.y : min.y,
                                i & 4 ? max.z : min.z);
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

/// A box without its top (the face at max.y).
inline Mesh open_box_mesh(const dvec3& min, const dvec3& max) {
  Mesh mesh = box_mesh(min, max);
  mesh.triangles.erase(mesh.triangles.begin() + 6, mesh.triangles.begin() + 8);
  return mesh;
}

/// A ring about the y axis, closed, 2 · around · across triangles, outward.
inline Mesh torus_mesh(double ring_radius, double tube_radius, unsigned around, unsigned across) {
  Mesh mesh;
  for (unsigned i = 0; i < around; ++i) {
    const double u = glm::two_pi<double>() * i / around;
    for (unsigned j = 0; j < across; ++j) {
      const double v = glm::two_pi<double>() * j / across;
      const double r = ring_radius + tube_radius * std::cos(v);
      mesh.positions.emplace_back(r * std::cos(u), tube_radius * std::sin(v), r * std::sin(u));
    }
  }
  for (unsigned i = 0; i < around; ++i) {
    for (unsigned j = 0; j < across; ++j) {
      const unsigned i1 = (i + 1) % around;
      const unsigned j1 = (j + 1) % across;
      const unsigned a = i * across + j;
      const unsigned b = i1 * across + j;
      const unsigned c = i1 * across + j1;
      const unsigned d = i * across + j1;
      mesh.triangles.emplace_back(a, c, b);
      mesh.triangles.emplace_back(a, d, c);
    }
  }
  return mesh;
}

/// A closed, star-shaped blob of longitude-latitude quads; its radius varies by `bumps` (0: a
/// ball).
inline Mesh blob_mesh(double radius, double bumps, unsigned rings) {
  Mesh mesh;
  const unsigned segments = 2 * rings;
  const auto point = [&](double theta, double phi) {
    const double r = radius * (1.0 + bumps * std::sin(3.0 * theta) * std::cos(4.0 * phi));
    return r *
           dvec3(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
  };
  mesh.positions.push_back(point(0.0, 0.0));
  for (unsigned i = 1; i < rings; ++i) {
    for (unsigned j = 0; j < segments; ++j) {
      mesh.positions.push_back(
          point(glm::pi<double>() * i / rings, glm::two_pi<double>() * j / segments));
    }
  }
  mesh.positions.push_back(point(glm::pi<double>(), 0.0));
  const auto south = static_cast<unsigned>(mesh.positions.size() - 1);
  const auto at = [&](unsigned i, unsigned j) { return 1 + (i - 1) * segments + j % segments; };
  for (unsigned j = 0; j < segments; ++j) {
    mesh.triangles.emplace_back(0, at(1, j + 1), at(1, j));
    mesh.triangles.emplace_back(south, at(rings - 1, j), at(rings - 1, j + 1));
    for (unsigned i = 1; i + 1 < rings; ++i) {
      mesh.triangles.emplace_back(at(i, j), at(i, j + 1), at(i + 1, j + 1));
      mesh.triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i + 1, j));
    }
  }
  return mesh;
}

inline dvec3 random_point(Rng& rng, double half_side) {
  const double x = rng.uniform();
  const double y = rng.uniform();
  const double z = rng.uniform();
  return half_side * (2.0 * dvec3(x, y, z) - 1.0);
}

}  // namespace collage::test
