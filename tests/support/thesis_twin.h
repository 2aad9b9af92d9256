#pragma once

#include <span>
#include <vector>

#include "geometry/instance.h"
#include "packing/choose.h"
#include "packing/options.h"
#include "packing/pack.h"
#include "packing/target.h"
#include "packing/voxel_grid.h"

namespace collage::test {

/// An element as the thesis has it: a mesh, the centre of its bounding sphere and its size.
struct TwinElement {
  Mesh mesh;
  dvec3 center;
  double size;
  dvec3 farthest_direction;
};

/// The placement of Muhm 2011, chapter IV, to the letter and on one thread: each step looks at all
/// voxels (Figs. 9 and 12), a distance is the least over all vertices, edges and faces (Fig. 13,
/// eqs. 4.1 to 4.14), inside is decided by the hits of two rays (IV.2.1). The slow twin of pack():
/// the oracle of its tests and the baseline of its benchmark. What the thesis leaves open, which of
/// several elements is chosen and how it is turned about its axis, is decided as in pack().
class ThesisTwin {
 public:
  ThesisTwin(const Target& target, const VoxelGrid& grid, std::vector<TwinElement> elements,
             const PackingOptions& options);

  /// Runs the main loop; returns the instances in order of placement.
  std::vector<Instance> run();

  [[nodiscard]] std::size_t voxels_inside_instances() const { return voxels_inside_instances_; }

 private:
  struct Voxel {
    dvec3 point;
    double signed_distance;
    dvec3 to_surface;
    enum class State { outside, free, filled } state;
  };
  /// The new element, in the world.
  struct Placed {
    std::vector<dvec3> vertices;
    const std::vector<uvec3>& faces;
    const std::vector<glm::uvec2>& edges;
    dvec3 center;
    double radius;
  };

  Voxel* largest_hole();
  Instance place(const Voxel& hole, const Choice& choice, double spin_radians) const;
  void update(const Instance& instance);
  void flag_interior_voxels(const Placed& element);
  static void compute_closest(Voxel& voxel, const Placed& element);
  [[nodiscard]] static bool inside(const dvec3& point, const Placed& element);

  std::vector<Voxel> voxels_;
  std::vector<TwinElement> elements_;
  std::vector<std::vector<glm::uvec2>> edges_;
  PackingOptions options_;
  double longest_side_;
  std::size_t voxels_inside_instances_ = 0;
};

}  // namespace collage::test
