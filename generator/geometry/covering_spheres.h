#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/bounding_sphere.h"
#include "geometry/solid.h"

namespace collage {

/// Spheres whose union holds a solid, surface and inside: no part of another shape that keeps clear
/// of them can be in it.
struct SphereCover {
  /// By how much a sphere reaches beyond the solid at most: its radius is the depth of its centre
  /// below the surface + bulge.
  double bulge = 0.0;
  std::vector<Sphere> spheres;
};

/// Covers a solid, in its unit frame, with spheres round points of its medial axis and its inside.
/// What must be covered is sampled: 7,000 points of the surface, vertices (of more than 4,000
/// some), and points of a lattice inside. Candidates for centres are the centres of the largest
/// balls that touch a surface point from inside (shrinking balls: Ma, Bae and Choi 2012, "3D medial
/// axis point approximation using nearest neighbors and the normal field"), the surface point
/// itself where there is no such ball, as on an open sheet, vertices, and lattice points. Safe to
/// use from one thread; runs on all. Build: some 100,000 closest-point queries.
class SphereCoverer {
 public:
  /// `unit_mesh` is the solid's mesh in its unit frame, which it must stay in; see in_unit_frame().
  SphereCoverer(const Solid& solid, const Mesh& unit_mesh);

  /// The least bulge, to 3 %, at which greedy choice needs no more than `count` spheres, of which
  /// the unit ball is one that always does; count ≥ 1. All samples are covered.
  [[nodiscard]] SphereCover cover(std::size_t count) const;

 private:
  using Bits = std::vector<std::uint64_t>;

  void add_samples(const Mesh& unit_mesh);
  void add_lattice(const Solid& solid);
  void add_candidates(const Solid& solid);
  /// Puts samples from `first` to before `last` in an order in which neighbours share a word.
  void group_samples(std::size_t first, std::size_t last);
  [[nodiscard]] std::vector<Bits> covered_by_each(double bulge) const;
  /// Greedily, the sphere that covers most of what is left first; empty where over `limit` are
  /// needed.
  [[nodiscard]] std::vector<std::uint32_t> choose(double bulge, std::size_t limit) const;

  /// Until they are grouped, points of the surface come first, as many as there are normals.
  std::vector<dvec3> samples_;
  /// Round the samples of each word of Bits.
  std::vector<Sphere> groups_;
  std::vector<dvec3> normals_;
  std::vector<dvec3> corners_;
  std::vector<dvec3> lattice_;
  /// Radius is the depth below the surface.
  std::vector<Sphere> candidates_;
};

}  // namespace collage
