#include "audit/measures.h"

#include "audit/instance_index.h"
#include "audit/target_shape.h"

namespace collage {
namespace {

/// A part of longer work: what it has done of itself, told as what that is of the whole.
class Part : public Status {
 public:
  Part(Status& whole, double begin, double end) : whole_(whole), begin_(begin), end_(end) {}

  void update(double fraction, std::string_view detail) override {
    whole_.update(begin_ + fraction * (end_ - begin_), detail);
  }
  void note(std::string_view line) override { whole_.note(line); }
  [[nodiscard]] bool stop_requested() const override { return whole_.stop_requested(); }

 private:
  Status& whole_;
  double begin_;
  double end_;
};

std::vector<double> radii(const InstanceIndex& sculpture) {
  std::vector<double> radii;
  radii.reserve(sculpture.instances().size());
  for (std::uint32_t i = 0; i < sculpture.instances().size(); ++i) {
    radii.push_back(sculpture.solid(i).radius() * sculpture.instances()[i].scale);
  }
  return radii;
}

Kinds kinds_of(const InstanceIndex& sculpture) {
  std::vector<std::uint32_t> kinds;
  std::vector<dvec3> centers;
  for (std::uint32_t i = 0; i < sculpture.instances().size(); ++i) {
    const Instance& instance = sculpture.instances()[i];
    kinds.push_back(instance.element);
    centers.push_back(instance.world_from_element(sculpture.solid(i).center()));
  }
  return mix_of_kinds(kinds, centers, sculpture.elements().size());
}

}  // namespace

Measures measure(const MeasureInput& input, Status& status) {
  const InstanceIndex sculpture(input.elements, input.instances);
  Measures result;
  result.sizes = size_distribution(radii(sculpture));
  result.orientations = orientations(input.instances);
  result.kinds = kinds_of(sculpture);
  double side = input.target_side;
  // Shares of the time as they are for a hundred thousand instances.
  Part outlines(status, 0.0, 0.5);
  Part distances(status, 0.5, 0.55);
  Part filling(status, 0.55, 0.6);
  Part holes(status, 0.6, 0.8);
  Part touching(status, 0.8, 0.95);
  Part linking(status, 0.95, 1.0);
  if (input.target != nullptr) {
    const TargetShape target(*input.target);
    side = side > 0.0 ? side : target.side;
    result.silhouette_iou = silhouette(target.mesh, sculpture, input.silhouette, outlines);
    result.surface_distance =
        surface_distance(target, sculpture, input.surface_distance, distances);
    result.fill = fill(target, sculpture, input.fill, filling);
    result.largest_hole = find_largest_hole(target, sculpture, holes);
  }
  result.target_side = side;
  if (side > 0.0) {
    result.contacts = contacts(sculpture, input.gap * side, touching);
  }
  result.links = find_links(sculpture, linking);
  return result;
}

}  // namespace collage
