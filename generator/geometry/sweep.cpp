#include "geometry/sweep.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>

namespace collage {
namespace {

dvec3 rounded(const dvec3& point) { return glm::round(point * 1e6) / 1e6; }

dvec3 middle(const Ring& ring) {
  dvec3 sum(0.0);
  for (const dvec3& point : ring) {
    sum += point - ring[0];
  }
  return ring[0] + sum / static_cast<double>(ring.size());
}

bool is_pole(const Ring& ring) {
  return std::all_of(ring.begin(), ring.end(), [&](const dvec3& p) { return p == ring[0]; });
}

std::uint32_t append_position(Mesh& mesh, const dvec3& position) {
  mesh.positions.push_back(position);
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

/// The two triangles of a quad, cut along the shorter diagonal.
void append_quad(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  const auto& p = mesh.positions;
  // The margin makes the choice the same all round a body of revolution.
  if (glm::distance(p[a], p[c]) <= glm::distance(p[b], p[d]) * (1.0 + 1e-9)) {
    mesh.triangles.emplace_back(a, b, c);
    mesh.triangles.emplace_back(a, c, d);
  } else {
    mesh.triangles.emplace_back(a, b, d);
    mesh.triangles.emplace_back(b, c, d);
  }
}

/// The number of a ring's first point; of its fan's tip where the ring is a pole.
using RingStart = std::uint32_t;

void append_band(Mesh& mesh, RingStart lower, RingStart upper, std::uint32_t points) {
  for (std::uint32_t i = 0; i < points; ++i) {
    const std::uint32_t next = (i + 1) % points;
    append_quad(mesh, lower + i, lower + next, upper + next, upper + i);
  }
}

enum class Facing { stack_start, stack_end };

void append_fan(Mesh& mesh, RingStart ring, std::uint32_t tip, std::uint32_t points,
                Facing facing) {
  for (std::uint32_t i = 0; i < points; ++i) {
    const std::uint32_t a = ring + i;
    const std::uint32_t b = ring + (i + 1) % points;
    mesh.triangles.push_back(facing == Facing::stack_end ? uvec3(a, b, tip) : uvec3(b, a, tip));
  }
}

}  // namespace

void append_rings(Mesh& mesh, std::vector<Ring> rings) {
  assert(rings.size() >= 2);
  for (Ring& ring : rings) {
    std::transform(ring.begin(), ring.end(), ring.begin(), rounded);
  }
  const auto points = static_cast<std::uint32_t>(rings[0].size());
  const std::uint32_t bottom = append_position(mesh, rounded(middle(rings.front())));
  const std::uint32_t top = append_position(mesh, rounded(middle(rings.back())));
  const bool bottom_pole = is_pole(rings.front());
  const bool top_pole = is_pole(rings.back());
  std::vector<RingStart> starts;
  const std::span<const Ring> all(rings);
  for (const Ring& ring : all.subspan(bottom_pole, all.size() - bottom_pole - top_pole)) {
    starts.push_back(static_cast<RingStart>(mesh.positions.size()));
    mesh.positions.insert(mesh.positions.end(), ring.begin(), ring.end());
  }
  append_fan(mesh, starts.front(), bottom, points, Facing::stack_start);
  for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
    append_band(mesh, starts[i], starts[i + 1], points);
  }
  append_fan(mesh, starts.back(), top, points, Facing::stack_end);
}

std::vector<Ring> lathe(std::span<const ProfilePoint> profile, int segments, double phase_radians) {
  std::vector<Ring> rings;
  for (const ProfilePoint& point : profile) {
    Ring& ring = rings.emplace_back();
    for (int i = 0; i < segments; ++i) {
      const double angle = phase_radians + 2.0 * std::numbers::pi * i / segments;
      ring.emplace_back(point.x * std::cos(angle), point.y, -point.x * std::sin(angle));
    }
  }
  return rings;
}

void set_smooth_normals(Mesh& mesh, double crease_degrees) {
  const double bend = std::cos(glm::radians(crease_degrees));
  std::vector<dvec3> face_normals;
  std::vector<std::vector<std::pair<std::uint32_t, double>>> around(mesh.positions.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<dvec3, 3> sides;
    for (int k = 0; k < 3; ++k) {
      sides[k] = glm::normalize(mesh.corner(t, (k + 1) % 3) - mesh.corner(t, k));
    }
    face_normals.push_back(glm::normalize(glm::cross(sides[0], sides[1])));
    for (int k = 0; k < 3; ++k) {
      const double cosine = glm::dot(sides[k], -sides[(k + 2) % 3]);
      around[mesh.triangles[t][k]].emplace_back(t, std::acos(glm::clamp(cosine, -1.0, 1.0)));
    }
  }
  mesh.normals.clear();
  mesh.normal_triangles.clear();
  std::map<std::tuple<double, double, double>, std::uint32_t> known;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    uvec3& indices = mesh.normal_triangles.emplace_back();
    for (int k = 0; k < 3; ++k) {
      dvec3 sum(0.0);
      for (const auto& [other, angle] : around[mesh.triangles[t][k]]) {
        sum += glm::dot(face_normals[t], face_normals[other]) >= bend ? angle * face_normals[other]
                                                                      : dvec3(0.0);
      }
      const dvec3 normal = rounded(glm::normalize(sum));
      const auto [entry, is_new] = known.try_emplace(
          {normal.x, normal.y, normal.z}, static_cast<std::uint32_t>(mesh.normals.size()));
      if (is_new) {
        mesh.normals.push_back(normal);
      }
      indices[k] = entry->second;
    }
  }
}

}  // namespace collage
