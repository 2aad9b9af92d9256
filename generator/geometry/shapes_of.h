#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include <tbb/parallel_for.h>

#include "geometry/mesh.h"

namespace collage {

/// For each element what `Shape` makes of its mesh, built on all threads and once for each
/// different mesh, as the same one may stand there for several elements.
template <class Shape>
std::vector<std::shared_ptr<const Shape>> shapes_of(std::span<const Mesh* const> elements) {
  std::vector<std::size_t> first(elements.size());
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const auto same = std::find(elements.begin(), elements.end(), elements[e]);
    first[e] = static_cast<std::size_t>(same - elements.begin());
  }
  std::vector<std::shared_ptr<const Shape>> shapes(elements.size());
  tbb::parallel_for(std::size_t{0}, elements.size(), [&](std::size_t e) {
    if (first[e] == e) {
      shapes[e] = std::make_shared<const Shape>(*elements[e]);
    }
  });
  for (std::size_t e = 0; e < elements.size(); ++e) {
    shapes[e] = shapes[first[e]];
  }
  return shapes;
}

}  // namespace collage
