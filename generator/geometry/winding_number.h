#pragma once

#include <vector>

#include "geometry/mesh.h"

namespace collage {

/// Generalised winding number of a mesh: how often its surface goes round a point, as the sum of
/// the triangles' signed solid angles ÷ 4π (Jacobson, Kavan and Sorkine 2013). 1 inside and 0
/// outside a closed mesh, in between near the gaps of an open one. Every triangle is visited: the
/// slow twin of WindingNumber.
double winding_number(const Mesh& mesh, const dvec3& point);

/// The same by a hierarchy: far clusters of triangles count as one dipole with its first moments
/// (Barill, Dickson, Schmidt, Levin and Jacobson 2018, eq. 6 to 13). The error is below 0.04 for
/// everyday meshes. Build O(n log n), query O(log n).
class WindingNumber {
 public:
  explicit WindingNumber(const Mesh& mesh);

  [[nodiscard]] double at(const dvec3& point) const;
  /// By Jacobson's threshold of one half, which also closes open meshes.
  [[nodiscard]] bool inside(const dvec3& point) const { return at(point) > 0.5; }

 private:
  struct Triangle {
    dvec3 a, b, c;
  };
  struct Cluster {
    dvec3 center{0.0};
    /// Sum of the triangles' area vectors.
    dvec3 dipole{0.0};
    /// Symmetric part of Σ (centroid - center) ⊗ area vector: xx, yy, zz, then 2xy, 2yz, 2zx.
    dvec3 moment_diagonal{0.0};
    dvec3 moment_mixed{0.0};
    /// Farther away than this the cluster stands for its triangles.
    double far_distance_squared = 0.0;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    /// The first child comes right behind; 0: a leaf.
    std::uint32_t second_child = 0;
  };

  std::uint32_t build(std::uint32_t begin, std::uint32_t end);
  void summarise(Cluster& cluster) const;

  std::vector<Triangle> triangles_;
  std::vector<Cluster> clusters_;
};

}  // namespace collage
