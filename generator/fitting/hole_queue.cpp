#include "fitting/hole_queue.h"

#include <algorithm>

namespace collage {

HoleQueue::Id HoleQueue::add(const Vacancy& vacancy) {
  const auto id = static_cast<Id>(vacancies_.size());
  vacancies_.push_back(vacancy);
  push(id);
  return id;
}

/// 21 bits an axis; where two cells share a key, holes of one are looked at for the other in vain.
std::uint64_t HoleMap::key(const glm::ivec3& cell) {
  constexpr std::uint64_t mask = (std::uint64_t{1} << 21) - 1;
  return (static_cast<std::uint64_t>(cell.x) & mask) |
         (static_cast<std::uint64_t>(cell.y) & mask) << 21 |
         (static_cast<std::uint64_t>(cell.z) & mask) << 42;
}

bool HoleMap::insert(const dvec3& hole, double apart) {
  const glm::ivec3 from = cell_at(hole - apart);
  const glm::ivec3 to = cell_at(hole + apart);
  for (int z = from.z; z <= to.z; ++z) {
    for (int y = from.y; y <= to.y; ++y) {
      for (int x = from.x; x <= to.x; ++x) {
        const auto found = cells_.find(key({x, y, z}));
        if (found != cells_.end() && std::ranges::any_of(found->second, [&](const dvec3& other) {
              return glm::distance(other, hole) < apart;
            })) {
          return false;
        }
      }
    }
  }
  cells_[key(cell_at(hole))].push_back(hole);
  return true;
}

void HoleMap::remove(const dvec3& hole) {
  const auto found = cells_.find(key(cell_at(hole)));
  if (found != cells_.end()) {
    std::erase(found->second, hole);
  }
}

}  // namespace collage
