#pragma once

#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace collage {

/// Squared distance from a point to a box; 0 within it.
inline double squared_distance(const Box& box, const dvec3& point) {
  const dvec3 away = glm::max(glm::max(box.min - point, point - box.max), dvec3(0.0));
  return glm::dot(away, away);
}

/// Squared distance between two boxes; 0 where they meet.
inline double squared_distance(const Box& a, const Box& b) {
  const dvec3 away = glm::max(glm::max(a.min - b.max, b.min - a.max), dvec3(0.0));
  return glm::dot(away, away);
}

inline std::vector<Box> boxes_of_points(std::span<const dvec3> points) {
  std::vector<Box> boxes;
  boxes.reserve(points.size());
  for (const dvec3& point : points) {
    boxes.push_back({point, point});
  }
  return boxes;
}

inline std::vector<Box> boxes_of_triangles(const Mesh& mesh) {
  std::vector<Box> boxes(mesh.triangles.size());
  for (std::size_t t = 0; t < boxes.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      boxes[t].include(mesh.corner(t, k));
    }
  }
  return boxes;
}

/// A box that holds all of them.
inline Box box_around(std::span<const Box> boxes) {
  Box around;
  for (const Box& box : boxes) {
    around = {glm::min(around.min, box.min), glm::max(around.max, box.max)};
  }
  return around;
}

}  // namespace collage
