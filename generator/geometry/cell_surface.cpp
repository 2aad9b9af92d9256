#include "geometry/cell_surface.h"

#include <map>
#include <tuple>

namespace collage {

PolygonMesh cell_surface(std::span<const double> xs, std::span<const double> ys,
                         std::span<const double> zs,
                         const std::function<bool(const dvec3& middle)>& is_solid) {
  const glm::ivec3 cells(xs.size() - 1, ys.size() - 1, zs.size() - 1);
  const auto at = [&](const glm::ivec3& corner) {
    return dvec3(xs[corner.x], ys[corner.y], zs[corner.z]);
  };
  const auto solid = [&](const glm::ivec3& cell) {
    return glm::all(glm::greaterThanEqual(cell, glm::ivec3(0))) &&
           glm::all(glm::lessThan(cell, cells)) && is_solid(0.5 * (at(cell) + at(cell + 1)));
  };
  PolygonMesh mesh;
  std::map<std::tuple<int, int, int>, std::uint32_t> corners;
  const auto corner = [&](const glm::ivec3& c) {
    const auto [entry, is_new] =
        corners.try_emplace({c.x, c.y, c.z}, static_cast<std::uint32_t>(mesh.positions.size()));
    if (is_new) {
      mesh.positions.push_back(at(c));
    }
    return entry->second;
  };
  const auto add_sides = [&](const glm::ivec3& cell) {
    for (int axis = 0; axis < 3; ++axis) {
      glm::ivec3 step(0);
      glm::ivec3 u(0);
      glm::ivec3 v(0);
      step[axis] = u[(axis + 1) % 3] = v[(axis + 2) % 3] = 1;
      if (!solid(cell + step)) {
        const glm::ivec3 o = cell + step;
        mesh.faces.push_back({corner(o), corner(o + u), corner(o + u + v), corner(o + v)});
      }
      if (!solid(cell - step)) {
        mesh.faces.push_back(
            {corner(cell), corner(cell + v), corner(cell + u + v), corner(cell + u)});
      }
    }
  };
  glm::ivec3 cell;
  for (cell.z = 0; cell.z < cells.z; ++cell.z) {
    for (cell.y = 0; cell.y < cells.y; ++cell.y) {
      for (cell.x = 0; cell.x < cells.x; ++cell.x) {
        if (solid(cell)) {
          add_sides(cell);
        }
      }
    }
  }
  return mesh;
}

}  // namespace collage
