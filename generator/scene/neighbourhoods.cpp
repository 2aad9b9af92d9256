#include "scene/neighbourhoods.h"

#include <algorithm>
#include <span>

namespace collage {
namespace {

constexpr std::size_t most = 16;
constexpr int halvings = 3;
constexpr double float_margin = 1e-6;  // of a box's distance and size; float rounds by 6e-8

using Indices = std::span<std::uint32_t>;

/// Box of the box `of_element` where the instance puts it.
Box placed(const Box& of_element, const Instance& instance) {
  Box box;
  for (int corner = 0; corner < 8; ++corner) {
    box.include(
        instance.world_from_element({(corner & 1) != 0 ? of_element.max.x : of_element.min.x,
                                     (corner & 2) != 0 ? of_element.max.y : of_element.min.y,
                                     (corner & 4) != 0 ? of_element.max.z : of_element.min.z}));
  }
  const dvec3 margin =
      float_margin * (glm::max(glm::abs(box.min), glm::abs(box.max)) + box.extent());
  return {box.min - margin, box.max + margin};
}

class Builder {
 public:
  explicit Builder(const Composition& composition) {
    std::vector<Box> of_element;
    for (const Composition::Element& element : composition.elements) {
      of_element.push_back(bounding_box(element.mesh));
    }
    for (const Instance& instance : composition.instances) {
      boxes_.push_back(placed(of_element[instance.element], instance));
    }
  }

  Neighbourhood build(Indices indices) const {
    Neighbourhood result;
    for (const std::uint32_t i : indices) {
      result.box.include(boxes_[i].min);
      result.box.include(boxes_[i].max);
    }
    if (indices.size() <= most) {
      result.instances.assign(indices.begin(), indices.end());
      std::ranges::sort(result.instances);
    } else {
      append_parts(result, indices, halvings);
    }
    return result;
  }

 private:
  void append_parts(Neighbourhood& parent, Indices indices, int halvings_left) const {
    if (halvings_left == 0 || indices.size() <= most) {
      parent.parts.push_back(build(indices));
      return;
    }
    const std::size_t half = halve(indices);
    append_parts(parent, indices.first(half), halvings_left - 1);
    append_parts(parent, indices.subspan(half), halvings_left - 1);
  }

  /// Sorts the lower half of the instances to the front; of two at one place the earlier is lower.
  std::size_t halve(Indices indices) const {
    Box centers;
    for (const std::uint32_t i : indices) {
      centers.include(boxes_[i].center());
    }
    const dvec3 extent = centers.extent();
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0
                     : extent.y >= extent.z                       ? 1
                                                                  : 2;
    const auto middle = indices.begin() + static_cast<std::ptrdiff_t>(indices.size() / 2);
    std::nth_element(indices.begin(), middle, indices.end(), [&](std::uint32_t a, std::uint32_t b) {
      const double at_a = boxes_[a].center()[axis];
      const double at_b = boxes_[b].center()[axis];
      return at_a < at_b || (at_a == at_b && a < b);
    });
    return indices.size() / 2;
  }

  std::vector<Box> boxes_;
};

}  // namespace

Neighbourhood neighbourhoods(const Composition& composition) {
  std::vector<std::uint32_t> indices(composition.instances.size());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    indices[i] = static_cast<std::uint32_t>(i);
  }
  return Builder(composition).build(indices);
}

}  // namespace collage
