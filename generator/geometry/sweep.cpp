#include "geometry/sweep.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace collage {
namespace {

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

void round_all(std::vector<Ring>& rings) {
  for (Ring& ring : rings) {
    std::transform(ring.begin(), ring.end(), ring.begin(), to_millionths);
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
  round_all(rings);
  const auto points = static_cast<std::uint32_t>(rings[0].size());
  const std::uint32_t bottom = append_position(mesh, to_millionths(middle(rings.front())));
  const std::uint32_t top = append_position(mesh, to_millionths(middle(rings.back())));
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

void append_ring_loop(Mesh& mesh, std::vector<Ring> rings) {
  assert(rings.size() >= 3);
  round_all(rings);
  const auto points = static_cast<std::uint32_t>(rings[0].size());
  const auto count = static_cast<std::uint32_t>(rings.size());
  const auto first = static_cast<RingStart>(mesh.positions.size());
  for (const Ring& ring : rings) {
    mesh.positions.insert(mesh.positions.end(), ring.begin(), ring.end());
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    append_band(mesh, first + i * points, first + (i + 1) % count * points, points);
  }
}

Ring section_ring(const Frame& frame, std::span<const dvec2> section, double scale) {
  Ring ring;
  for (const dvec2& point : section) {
    ring.push_back(frame.point(scale * point));
  }
  return ring;
}

std::vector<dvec2> ellipse(double half_width, double half_height, int corners,
                           double phase_radians) {
  std::vector<dvec2> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = phase_radians + 2.0 * std::numbers::pi * i / corners;
    points.emplace_back(half_width * std::cos(angle), half_height * std::sin(angle));
  }
  return points;
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

}  // namespace collage
