#include "geometry/handles.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "geometry/frames.h"

namespace collage {
namespace {

using Section = std::vector<dvec2>;

Section section_in(const Frame& frame, const PolygonMesh& mesh, const PolygonMesh::Face& face) {
  Section section;
  for (const std::uint32_t corner : face) {
    const dvec3 arm = mesh.positions[corner] - frame.origin;
    section.emplace_back(glm::dot(arm, frame.u), glm::dot(arm, frame.v));
  }
  return section;
}

dvec2 turned(const dvec2& p, double angle) {
  return {p.x * std::cos(angle) - p.y * std::sin(angle),
          p.x * std::sin(angle) + p.y * std::cos(angle)};
}

/// The angle by which `from` must be turned to be nearest to `to`, corner by corner.
double turn_between(const Section& from, const Section& to) {
  double sine = 0.0;
  double cosine = 0.0;
  for (std::size_t k = 0; k < from.size(); ++k) {
    sine += from[k].x * to[k].y - from[k].y * to[k].x;
    cosine += glm::dot(from[k], to[k]);
  }
  return std::atan2(sine, cosine);
}

void add_handle(PolygonMesh& mesh, const FacePair& pair, const HandleShape& shape) {
  const dvec3 from = face_middle(mesh, pair.from);
  const dvec3 to = face_middle(mesh, pair.to);
  // A tunnel sets out inwards, but its section is the same: `along` is the way the curve goes.
  const auto curve = bezier_curve(from, from + shape.reach * face_normal(mesh, pair.from),
                                  to + shape.reach * face_normal(mesh, pair.to), to, shape.steps);
  const auto n = static_cast<std::uint32_t>(mesh.faces[pair.from].size());
  const dvec3 first_corner = mesh.positions[mesh.faces[pair.from][0]];
  const std::vector<Frame> frames = frames_along(curve, first_corner - from);

  const Section start = section_in(frames.front(), mesh, mesh.faces[pair.from]);
  PolygonMesh::Face end_face(mesh.faces[pair.to].rbegin(), mesh.faces[pair.to].rend());
  Section end = section_in(frames.back(), mesh, end_face);
  const auto rotate = [&](std::uint32_t corners) {
    std::rotate(end_face.begin(), end_face.begin() + corners, end_face.end());
    std::rotate(end.begin(), end.begin() + corners, end.end());
  };
  const double step = 2.0 * std::numbers::pi / n;
  double turn = turn_between(start, end);
  for (std::uint32_t k = 1; k < n && std::abs(turn) > 0.5 * step + 1e-9; ++k) {
    rotate(1);
    turn = turn_between(start, end);
  }
  const auto more = static_cast<std::uint32_t>(((shape.twist % static_cast<int>(n)) + n) % n);
  rotate(more);
  turn += shape.twist * step;

  for (int i = 1; i < shape.steps; ++i) {
    const double t = static_cast<double>(i) / shape.steps;
    const double width = 1.0 + (shape.waist - 1.0) * 4.0 * t * (1.0 - t);
    std::vector<dvec3> ring;
    for (std::uint32_t k = 0; k < n; ++k) {
      const dvec2 flat = glm::mix(start[k], turned(end[k], -turn), t);
      ring.push_back(frames[i].point(width * turned(flat, t * turn)));
    }
    raise_face(mesh, pair.from, ring);
  }
  const PolygonMesh::Face& last = mesh.faces[pair.from];
  std::vector<PolygonMesh::Face> band;
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t next = (k + 1) % n;
    band.push_back({last[k], last[next], end_face[next], end_face[k]});
  }
  mesh.faces.insert(mesh.faces.end(), band.begin(), band.end());
  mesh.faces[pair.from].clear();
  mesh.faces[pair.to].clear();
}

}  // namespace

PolygonMesh with_handles(PolygonMesh mesh, std::span<const FacePair> pairs,
                         const HandleShape& shape) {
  for (const FacePair& pair : pairs) {
    assert(pair.from != pair.to);
    assert(!mesh.faces[pair.from].empty());
    assert(mesh.faces[pair.from].size() == mesh.faces[pair.to].size());
    add_handle(mesh, pair, shape);
  }
  std::erase_if(mesh.faces, [](const PolygonMesh::Face& face) { return face.empty(); });
  return mesh;
}

}  // namespace collage
