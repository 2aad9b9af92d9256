#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "geometry/mesh_check.h"
#include "geometry/sheets.h"

namespace collage {
namespace {

class Orienter {
 public:
  Orienter(Mesh& mesh, Sheets found)
      : mesh_(mesh), sheets_(std::move(found.sheets)), flipped_(std::move(found.flipped)) {}

  Orientation run();

 private:
  bool lies_within(const Sheet& inner, const Sheet& outer) const;
  const Sheet& outermost(const Sheet& sheet) const;
  bool must_turn(const Sheet& sheet) const;
  void apply();

  Mesh& mesh_;
  std::vector<Sheet> sheets_;
  std::vector<char> flipped_;
};

/// A triangle's solid angle seen from the origin (Van Oosterom and Strackee 1983).
double solid_angle(const dvec3& a, const dvec3& b, const dvec3& c) {
  const double la = glm::length(a);
  const double lb = glm::length(b);
  const double lc = glm::length(c);
  return 2.0 *
         std::atan2(glm::dot(a, glm::cross(b, c)),
                    la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
}

bool is_within(const Box& inner, const Box& outer) {
  return glm::all(glm::lessThanEqual(outer.min, inner.min)) &&
         glm::all(glm::lessThanEqual(inner.max, outer.max));
}

/// Whether `inner`, by two of its corners or three, lies inside `outer`.
bool Orienter::lies_within(const Sheet& inner, const Sheet& outer) const {
  if (!is_within(inner.box, outer.box)) {
    return false;
  }
  const std::size_t step = std::max<std::size_t>(1, inner.triangles.size() / 2);
  for (std::size_t i = 0; i < inner.triangles.size(); i += step) {
    const dvec3 point = mesh_.corner(inner.triangles[i], 0);
    double angle = 0.0;
    for (const std::uint32_t t : outer.triangles) {
      const auto [a, b, c] = oriented_corners(mesh_, flipped_, t);
      angle += solid_angle(a - point, b - point, c - point);
    }
    if (std::abs(angle) < 2.0 * std::numbers::pi) {
      return false;
    }
  }
  return true;
}

/// The largest closed sheet that this one lies within; itself where there is none.
const Sheet& Orienter::outermost(const Sheet& sheet) const {
  const Sheet* largest = &sheet;
  for (const Sheet& other : sheets_) {
    if (&other != &sheet && other.closed && std::abs(other.volume) > std::abs(largest->volume) &&
        lies_within(sheet, other)) {
      largest = &other;
    }
  }
  return *largest;
}

bool Orienter::must_turn(const Sheet& sheet) const {
  if (sheet.one_sided) {
    return false;
  }
  if (sheet.closed) {
    const bool maybe = std::any_of(sheets_.begin(), sheets_.end(), [&](const Sheet& other) {
      return other.closed && other.volume < 0 && is_within(sheet.box, other.box);
    });
    return maybe && outermost(sheet).volume < 0;
  }
  const double ball = std::pow(sheet.area, 1.5) / (6.0 * std::sqrt(std::numbers::pi));
  return sheet.volume < -ball / 20.0;
}

/// Turns the marked triangles. A normal that would point inwards gets a twin that does not.
void Orienter::apply() {
  for (std::uint32_t t = 0; t < flipped_.size(); ++t) {
    if (flipped_[t] == 0) {
      continue;
    }
    for (auto* indices : {&mesh_.triangles, &mesh_.normal_triangles, &mesh_.uv_triangles}) {
      if (!indices->empty()) {
        std::swap((*indices)[t].y, (*indices)[t].z);
      }
    }
    if (mesh_.normal_triangles.empty()) {
      continue;
    }
    const dvec3 a = mesh_.corner(t, 0);
    const dvec3 outward = glm::cross(mesh_.corner(t, 1) - a, mesh_.corner(t, 2) - a);
    for (int k = 0; k < 3; ++k) {
      std::uint32_t& index = mesh_.normal_triangles[t][k];
      const dvec3 normal = mesh_.normals[index];
      if (glm::dot(normal, outward) < 0) {
        index = static_cast<std::uint32_t>(mesh_.normals.size());
        mesh_.normals.push_back(-normal);
      }
    }
  }
}

Orientation Orienter::run() {
  Orientation result;
  result.sheets = sheets_.size();
  result.mended_triangles =
      static_cast<std::size_t>(std::count(flipped_.begin(), flipped_.end(), 1));
  const bool all_outward = std::none_of(sheets_.begin(), sheets_.end(),
                                        [](const Sheet& sheet) { return sheet.volume < 0; });
  std::vector<const Sheet*> turned;
  for (const Sheet& sheet : sheets_) {
    result.one_sided_sheets += sheet.one_sided ? 1 : 0;
    if (!all_outward && must_turn(sheet)) {
      turned.push_back(&sheet);
    }
  }
  result.turned_sheets = turned.size();
  for (const Sheet* sheet : turned) {
    for (const std::uint32_t t : sheet->triangles) {
      flipped_[t] ^= 1;
    }
  }
  apply();
  return result;
}

}  // namespace

Orientation orient(Mesh& mesh) { return Orienter(mesh, find_sheets(mesh)).run(); }

}  // namespace collage
