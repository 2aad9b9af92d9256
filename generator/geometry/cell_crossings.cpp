#include "geometry/cell_crossings.h"

#include <cmath>

#include <tbb/parallel_for.h>

namespace collage {
namespace {

/// Determinants of lengths up to 2 come with errors below 10⁻¹⁴.
constexpr double unsure = 1e-13;

/// Six times the volume of a tetrahedron; above 0 where d is behind triangle abc.
double volume(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d) {
  return glm::dot(a - d, glm::cross(b - d, c - d));
}

/// The change of the winding number: -1 where the way leaves by the triangle, +1 where it enters, 0
/// where it passes by; nothing where that is too close to call.
std::optional<int> crossing(const std::array<dvec3, 3>& t, const dvec3& from, const dvec3& to) {
  const double side_from = volume(t[0], t[1], t[2], from);
  const double side_to = volume(t[0], t[1], t[2], to);
  if (std::min(side_from, side_to) > unsure || std::max(side_from, side_to) < -unsure) {
    return 0;
  }
  double least = 1e300;
  double most = -1e300;
  for (std::size_t k = 0; k < 3; ++k) {
    const double turn = volume(t[k], t[(k + 1) % 3], to, from);
    least = std::min(least, turn);
    most = std::max(most, turn);
  }
  if (least < -unsure && most > unsure) {
    return 0;
  }
  const bool sure = std::abs(side_from) > unsure && std::abs(side_to) > unsure &&
                    (least > unsure || most < -unsure);
  return sure ? std::optional<int>(side_from > 0.0 ? -1 : 1) : std::nullopt;
}

/// A plane as a unit normal and the height of the origin; zeros for a triangle too thin to tell.
glm::vec4 plane_below(const std::array<dvec3, 3>& t, const dvec3& above) {
  constexpr double thinnest = 1e-6;
  const dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double length = glm::length(normal);
  const double longest =
      std::max({glm::distance(t[0], t[1]), glm::distance(t[1], t[2]), glm::distance(t[2], t[0])});
  if (length <= thinnest * longest * longest) {
    return glm::vec4(0.0F);
  }
  const dvec3 unit = glm::dot(normal, above - t[0]) < 0.0 ? -normal / length : normal / length;
  return {unit, -glm::dot(unit, t[0])};
}

}  // namespace

CellCrossings::CellCrossings(const Mesh& mesh, const WindingNumber& winding_number,
                             int cells_per_side)
    : cells_per_side_(cells_per_side) {
  list_triangles(mesh);
  const auto side = static_cast<std::size_t>(cells_per_side);
  windings_.resize(side * side * side);
  tbb::parallel_for(std::size_t{0}, side * side,
                    [&](std::size_t row) { walk_row(row * side, winding_number); });
}

dvec3 CellCrossings::middle(std::size_t cell) const {
  const auto side = static_cast<std::size_t>(cells_per_side_);
  const std::size_t row = cell / side;
  const glm::u64vec3 index(cell % side, row % side, row / side);
  return (dvec3(index) + 0.5) * (2.0 / cells_per_side_) - 1.0;
}

/// Lists each triangle in the cells that its box and its plane meet.
void CellCrossings::list_triangles(const Mesh& mesh) {
  const int side = cells_per_side_;
  const double half = 1.0 / side + margin;
  const auto visit_cells = [&](const Triangle& t, const auto& visit) {
    Box box;
    for (const dvec3& corner : t) {
      box.include(corner);
    }
    const auto cell_of = [&](const dvec3& point) {
      const dvec3 cell = glm::floor((point + 1.0) * (0.5 * side));
      return glm::ivec3(glm::clamp(cell, dvec3(0.0), dvec3(side - 1)));
    };
    const glm::ivec3 first = cell_of(box.min - margin);
    const glm::ivec3 last = cell_of(box.max + margin);
    const dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
    const double reach = half * (std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z));
    glm::ivec3 at;
    for (at.z = first.z; at.z <= last.z; ++at.z) {
      for (at.y = first.y; at.y <= last.y; ++at.y) {
        for (at.x = first.x; at.x <= last.x; ++at.x) {
          const std::size_t row = static_cast<std::size_t>(at.z) * side + at.y;
          const std::size_t cell = row * side + at.x;
          if (std::abs(glm::dot(normal, middle(cell) - t[0])) <= reach) {
            visit(cell);
          }
        }
      }
    }
  };
  triangles_.reserve(mesh.triangles.size());
  starts_.assign(static_cast<std::size_t>(side) * side * side + 1, 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    triangles_.push_back({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)});
    visit_cells(triangles_[t], [&](std::size_t cell) { ++starts_[cell + 1]; });
  }
  for (std::size_t cell = 1; cell < starts_.size(); ++cell) {
    starts_[cell] += starts_[cell - 1];
  }
  items_.resize(starts_.back());
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
  planes_.resize(items_.size());
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    visit_cells(triangles_[t], [&](std::size_t cell) {
      planes_[next[cell]] = plane_below(triangles_[t], middle(cell));
      items_[next[cell]++] = static_cast<std::uint32_t>(t);
    });
  }
}

/// From the middle of the cube's face, which is outside, through the middles of a row of cells.
void CellCrossings::walk_row(std::size_t first, const WindingNumber& winding_number) {
  const dvec3 half_step(1.0 / cells_per_side_, 0.0, 0.0);
  std::optional<int> winding = 0;
  for (std::size_t cell = first; cell < first + static_cast<std::size_t>(cells_per_side_); ++cell) {
    const dvec3 here = middle(cell);
    const std::optional<int> out = change(cell, here - half_step);
    if (winding && out) {
      winding = *winding - *out;
    } else {
      winding = static_cast<int>(std::lround(winding_number.at(here)));
    }
    windings_[cell] = static_cast<std::int16_t>(*winding);
    const std::optional<int> onward = change(cell, here + half_step);
    winding = onward ? std::optional<int>(*winding + *onward) : std::nullopt;
  }
}

std::optional<int> CellCrossings::change(std::size_t cell, const dvec3& point) const {
  int sum = 0;
  for (std::uint32_t i = starts_[cell]; i < starts_[cell + 1]; ++i) {
    if (is_beside_middle(planes_[i], glm::vec3(point))) {
      continue;
    }
    const std::optional<int> crossed = crossing(triangles_[items_[i]], middle(cell), point);
    if (!crossed) {
      return std::nullopt;
    }
    sum += *crossed;
  }
  return sum;
}

std::optional<int> CellCrossings::winding_at(std::size_t cell, const dvec3& point) const {
  const std::optional<int> changed = change(cell, point);
  return changed ? std::optional<int>(windings_[cell] + *changed) : std::nullopt;
}

}  // namespace collage
