#include "geometry/letters.h"

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "geometry/font_outline.h"
#include "geometry/inset.h"
#include "geometry/polygon.h"
#include "geometry/smooth_normals.h"
#include "geometry/topology.h"

namespace collage {
namespace {

constexpr double curve_tolerance = 0.001;
constexpr double crease_degrees = 30.0;
/// A bevel takes no more of half the depth than this, and of the way to where strokes vanish.
constexpr double most_of_depth = 0.9;
constexpr double most_of_stroke = 0.8;
constexpr double least_bevel = 0.001;

/// The region's parts, each with its holes.
std::vector<Region> parts_of(const Region& region, const std::vector<uvec3>& triangles) {
  DisjointSets sets(point_count(region));
  for (const uvec3& t : triangles) {
    sets.unite(t.x, t.y);
    sets.unite(t.y, t.z);
  }
  std::map<std::uint32_t, Region> parts;
  std::uint32_t first = 0;
  for (const Contour& contour : region) {
    parts[sets.find(first)].push_back(contour);
    first += static_cast<std::uint32_t>(contour.size());
  }
  std::vector<Region> result;
  result.reserve(parts.size());
  for (auto& [root, part] : parts) {
    result.push_back(std::move(part));
  }
  return result;
}

/// The part drawn in by `bevel`, or by as much as its strokes allow.
Inset widest_inset(const Region& part, double bevel) {
  if (auto whole = inset(part, bevel)) {
    return std::move(*whole);
  }
  double possible = 0.0;
  double too_much = bevel;
  for (int i = 0; i < 8; ++i) {
    const double middle = 0.5 * (possible + too_much);
    (inset(part, middle) ? possible : too_much) = middle;
  }
  const double reduced = most_of_stroke * possible;
  auto result = reduced < least_bevel ? std::nullopt : inset(part, reduced);
  return result ? std::move(*result) : inset(part, 0.0).value();
}

/// Adds triangles of the front, and their mirror images of the back.
class Slab {
 public:
  Slab(Mesh& mesh, const Inset& inset, double half_depth) : mesh_(mesh) {
    const double bevel = inset.points.back().z;
    front_ = static_cast<std::uint32_t>(mesh.positions.size());
    back_ = front_ + static_cast<std::uint32_t>(inset.points.size());
    for (const double side : {1.0, -1.0}) {
      for (const dvec3& point : inset.points) {
        mesh.positions.emplace_back(point.x, point.y, side * (half_depth - bevel + point.z));
      }
    }
  }

  void append_face(const uvec3& t) {
    mesh_.triangles.push_back(t + front_);
    mesh_.triangles.push_back(uvec3(t.z, t.y, t.x) + back_);
  }
  void append_strip(const std::vector<std::uint32_t>& polygon) {
    std::vector<dvec3> corners;
    corners.reserve(polygon.size());
    for (const std::uint32_t index : polygon) {
      corners.push_back(mesh_.positions[front_ + index]);
    }
    for (const auto& [a, b, c] : triangulate(corners)) {
      append_face({polygon[static_cast<std::size_t>(a)], polygon[static_cast<std::size_t>(b)],
                   polygon[static_cast<std::size_t>(c)]});
    }
  }
  /// From front to back over the side of a contour from point `a` to point `b`.
  void append_wall(std::uint32_t a, std::uint32_t b) {
    mesh_.triangles.emplace_back(back_ + a, back_ + b, front_ + b);
    mesh_.triangles.emplace_back(back_ + a, front_ + b, front_ + a);
  }

 private:
  Mesh& mesh_;
  std::uint32_t front_;
  std::uint32_t back_;
};

void append_part(Mesh& mesh, const Region& part, const Inset& inset, double half_depth) {
  Slab slab(mesh, inset, half_depth);
  for (const uvec3& t : inset.cap) {
    slab.append_face(t);
  }
  for (const auto& face : inset.faces) {
    slab.append_strip(face);
  }
  std::uint32_t first = 0;
  for (const Contour& contour : part) {
    const auto n = static_cast<std::uint32_t>(contour.size());
    for (std::uint32_t i = 0; i < n; ++i) {
      slab.append_wall(first + i, first + (i + 1) % n);
    }
    first += n;
  }
}

std::vector<Region> parts_of_text(const LetterOptions& options) {
  const FontFile font = find_font(options.font);
  const auto region = united(read_outlines(font, options.string, curve_tolerance));
  const auto triangles = region ? triangulated(*region) : std::nullopt;
  if (!triangles) {
    throw Error({font.path}, "has outlines that cross themselves too often to be made solid",
                "choose another font");
  }
  if (region->empty()) {
    throw Error("the text for letters, \"" + options.string + "\", is blank",
                "write a letter in it");
  }
  return parts_of(*region, *triangles);
}

}  // namespace

Mesh make_letters(const LetterOptions& options, Status& status) {
  const std::vector<Region> parts = parts_of_text(options);
  const double half_depth = 0.5 * options.depth;
  const double wanted = std::min(options.bevel, most_of_depth * half_depth);
  Mesh mesh;
  double narrowest = wanted;
  for (const Region& part : parts) {
    const Inset strip = widest_inset(part, wanted);
    narrowest = std::min(narrowest, strip.points.back().z);
    append_part(mesh, part, strip, half_depth);
  }
  if (narrowest < options.bevel) {
    status.note(
        fmt::format("\"{}\" is too thin for a bevel of {}; where it is thinnest it has {:.2g}",
                    options.string, options.bevel, narrowest));
  }
  set_smooth_normals(mesh, crease_degrees);
  return mesh;
}

}  // namespace collage
