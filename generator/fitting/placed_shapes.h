#pragma once

#include <cstdint>
#include <vector>

#include "fitting/free_space.h"
#include "fitting/pose_finder.h"
#include "fitting/surroundings.h"
#include "packing/options.h"

namespace collage {

/// A target with, where it is a mesh, what its surface is tested by.
struct ShapeTarget {
  const Target& target;
  const CollisionShape* surface = nullptr;
};

/// The instances placed so far, and the exact test of what may come next to them.
class PlacedShapes {
 public:
  /// `spacing` is the air to be kept, in world units. Target and space must outlive this.
  PlacedShapes(const ShapeTarget& target, const FreeSpace& space, double spacing)
      : target_(target), space_(space), spacing_(spacing) {}

  [[nodiscard]] std::size_t size() const { return instances_.size(); }
  [[nodiscard]] const std::vector<Instance>& instances() const { return instances_; }
  [[nodiscard]] const ShapedElement& shape(std::uint32_t i) const { return *shapes_[i]; }
  [[nodiscard]] const Pose& pose(std::uint32_t i) const { return poses_[i]; }
  void add(const ShapedElement& shape, const Pose& pose, const Instance& instance);

  /// The surroundings of a pose, of instances from number `first` on, and of the target where that
  /// is 0. `ids` is room to work in.
  void find_surroundings(const Pose& pose, std::uint32_t first, std::vector<std::uint32_t>& ids,
                         Surroundings& surroundings) const;
  /// Whether a shape would meet the target or an instance, or where links are to be avoided hang in
  /// one. `ids` is room to work in.
  [[nodiscard]] bool blocks(const ShapedElement& shape, const Pose& pose, Linking linking,
                            std::vector<std::uint32_t>& ids) const;
  /// Whether a shape's loops and those of an instance go round each other.
  [[nodiscard]] bool linked(const ShapedElement& shape, const Pose& pose,
                            std::uint32_t other) const;
  /// The opening of an instance that has a ring.
  [[nodiscard]] PoseFinder::Opening opening_of(std::uint32_t host) const;

 private:
  /// Of instances from number `first` on, those that may come within `reach` of a point, rising.
  void find_near(const dvec3& center, double reach, std::uint32_t first,
                 std::vector<std::uint32_t>& ids) const;
  /// No more than the distance from a point to an instance.
  [[nodiscard]] double least_distance(std::uint32_t i, const dvec3& point) const;
  [[nodiscard]] bool leaves_target(const ShapedElement& shape, const Instance& instance) const;

  const ShapeTarget& target_;
  const FreeSpace& space_;
  double spacing_;
  std::vector<Instance> instances_;
  std::vector<const ShapedElement*> shapes_;
  std::vector<Pose> poses_;
};

}  // namespace collage
