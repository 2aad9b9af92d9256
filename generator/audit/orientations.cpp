#include "audit/orientations.h"

namespace collage {

std::optional<Orientations> orientations(std::span<const Instance> instances) {
  if (instances.empty()) {
    return std::nullopt;
  }
  const auto n = static_cast<double>(instances.size());
  glm::dmat4 scatter(0.0);
  for (const auto& [element, scale, q, translation] : instances) {
    const glm::dvec4 v(q.w, q.x, q.y, q.z);
    scatter += glm::outerProduct(v, v) / n;
  }
  double trace_of_square = 0.0;
  for (int column = 0; column < 4; ++column) {
    trace_of_square += glm::dot(scatter[column], scatter[column]);
  }
  return Orientations{4.0 / 3.0 * (1.0 - trace_of_square), 1.0 - 1.0 / n,
                      12.0 * n * (trace_of_square - 0.25)};
}

}  // namespace collage
