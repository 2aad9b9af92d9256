#include "fitting/distance_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <tbb/parallel_for.h>

namespace collage {

float DistanceField::value(const glm::vec3& steps, glm::vec3& direction) const {
  const auto [first, part] = cell_at(steps);
  const float* v = &values_[first];
  const float* w = v + layer_;
  const float along_x = mix(mix(v[1] - v[0], v[row_ + 1] - v[row_], part.y),
                            mix(w[1] - w[0], w[row_ + 1] - w[row_], part.y), part.z);
  const float v0 = mix(v[0], v[1], part.x);
  const float v1 = mix(v[row_], v[row_ + 1], part.x);
  const float w0 = mix(w[0], w[1], part.x);
  const float w1 = mix(w[row_], w[row_ + 1], part.x);
  const float front = mix(v0, v1, part.y);
  const float back = mix(w0, w1, part.y);
  const glm::vec3 slope(along_x, mix(v1 - v0, w1 - w0, part.z), back - front);
  constexpr float not_zero = std::numeric_limits<float>::min();
  direction = slope / (std::sqrt(glm::dot(slope, slope)) + not_zero);
  return mix(front, back, part.z);
}

/// Of the same sign, the value at p is no farther from 0 than its neighbour's and the way there; of
/// opposite signs, the two share that way.
void DistanceField::limit(const glm::ivec3& p, const glm::ivec3& neighbour) {
  if (glm::any(glm::lessThan(neighbour, glm::ivec3(0))) ||
      glm::any(glm::greaterThanEqual(neighbour, size_))) {
    return;
  }
  float& here = at(p);
  float& there = at(neighbour);
  const auto way = static_cast<float>(spacing_ * glm::length(dvec3(neighbour - p)));
  if (std::signbit(here) == std::signbit(there)) {
    here = std::copysign(std::min(std::abs(here), std::abs(there) + way), here);
  } else if (const float sum = std::abs(here) + std::abs(there); sum > way) {
    here *= way / sum;
    there *= way / sum;
  }
}

void DistanceField::close_gaps() {
  // Half of the 26 neighbours come before a point in each direction of the sweep.
  std::array<glm::ivec3, 13> before;
  for (int i = 0; i < 13; ++i) {
    before[static_cast<std::size_t>(i)] = glm::ivec3(i % 3, i / 3 % 3, i / 9) - 1;
  }
  for (const int way : {1, -1}) {
    glm::ivec3 step;
    for (step.z = 0; step.z < size_.z; ++step.z) {
      for (step.y = 0; step.y < size_.y; ++step.y) {
        for (step.x = 0; step.x < size_.x; ++step.x) {
          const glm::ivec3 p = way > 0 ? step : size_ - 1 - step;
          for (const glm::ivec3& offset : before) {
            limit(p, p + way * offset);
          }
        }
      }
    }
  }
}

DistanceMinima::DistanceMinima(const DistanceField& field)
    : blocks_((field.size() - 1 + (cells - 1)) / cells) {
  glm::ivec3 block;
  for (block.z = 0; block.z < blocks_.z; ++block.z) {
    for (block.y = 0; block.y < blocks_.y; ++block.y) {
      for (block.x = 0; block.x < blocks_.x; ++block.x) {
        const glm::ivec3 from = block * cells;
        const glm::ivec3 to = glm::min(from + cells, field.size() - 1);
        float least = field.at(from);
        glm::ivec3 p;
        for (p.z = from.z; p.z <= to.z; ++p.z) {
          for (p.y = from.y; p.y <= to.y; ++p.y) {
            for (p.x = from.x; p.x <= to.x; ++p.x) {
              least = std::min(least, field.at(p));
            }
          }
        }
        // Interpolation may round to less than its corners by a part in 10⁶ or so.
        values_.push_back(least - 1e-5F * std::abs(least));
      }
    }
  }
}

DistanceField sample_unit_distances(const Solid& solid, int points_per_side, double margin) {
  const double half = 1.0 + margin;
  DistanceField field(dvec3(-half), 2.0 * half / (points_per_side - 1),
                      glm::ivec3(points_per_side));
  tbb::parallel_for(0, points_per_side, [&](int z) {
    for (int y = 0; y < points_per_side; ++y) {
      double reach = std::numeric_limits<double>::infinity();
      for (int x = 0; x < points_per_side; ++x) {
        const dvec3 point = field.point({x, y, z});
        const double distance = solid.surface().find(point, reach)->distance;
        // The next point is one step away; the rest covers rounding.
        reach = distance + 1.01 * field.spacing();
        field.at({x, y, z}) = static_cast<float>(solid.inside(point) ? -distance : distance);
      }
    }
  });
  field.close_gaps();
  return field;
}

}  // namespace collage
