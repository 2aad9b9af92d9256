#include "packing/climb.h"

#include <array>

namespace collage {
namespace {

/// The hole's surroundings as the points of surfaces that were seen.
class SeenPoints {
 public:
  void add(const dvec3& point) {
    if (count_ < points_.size()) {
      points_[count_++] = point;
    }
  }
  [[nodiscard]] bool is_full() const { return count_ == points_.size(); }

  struct Nearest {
    dvec3 point;
    double distance;
  };
  /// Of one at least.
  [[nodiscard]] Nearest nearest(const dvec3& from) const {
    std::size_t best = 0;
    double best_squared = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count_; ++i) {
      const dvec3 away = from - points_[i];
      if (const double squared = glm::dot(away, away); squared < best_squared) {
        best = i;
        best_squared = squared;
      }
    }
    return {points_[best], std::sqrt(best_squared)};
  }

  /// A point less than `reach` from `center` where the nearest of them is far: by steps away from
  /// whichever is the nearest, ever shorter ones (as Bădoiu and Clarkson 2003 find enclosing
  /// balls).
  [[nodiscard]] dvec3 farthest(const dvec3& center, double reach) const {
    dvec3 best = center;
    double best_distance = nearest(center).distance;
    dvec3 at = center;
    for (int step = 0; step < steps; ++step) {
      const Nearest from = nearest(at);
      at += reach / ((step + 2) * from.distance) * (at - from.point);
      const double off = glm::distance(at, center);
      if (off > limit * reach) {
        at = center + limit * reach / off * (at - center);
      }
      if (const double distance = nearest(at).distance; distance > best_distance) {
        best = at;
        best_distance = distance;
      }
    }
    return best;
  }

 private:
  static constexpr int steps = 40;
  static constexpr double limit = 0.999;

  std::array<dvec3, 48> points_;
  std::size_t count_ = 0;
};

}  // namespace

Hole climbed(const Surfaces& surfaces, const Hole& hole, std::span<const SurfaceId> near,
             double reach) {
  constexpr int rounds = 8;
  constexpr double close_enough = 1.0 + 1e-3;
  SeenPoints seen;
  const auto see = [&](SurfaceId id, const dvec3& from, double clearance) {
    seen.add(from + clearance * surfaces.direction(id, from, clearance));
  };
  const auto ask = [&](SurfaceId id, const dvec3& point, double limit) {
    Nearest found{several_surfaces, static_cast<float>(limit)};
    surfaces.consider(id, point, found);
    return found;
  };

  const double limit = hole.clearance + 2.0 * reach;
  for (const SurfaceId id : near) {
    if (const Nearest found = ask(id, hole.center, limit); found.id == id) {
      see(id, hole.center, found.clearance);
    }
  }
  if (const Nearest found = ask(target_surface, hole.center, limit); found.id == target_surface) {
    see(target_surface, hole.center, found.clearance);
  }

  Hole best = hole;
  for (int round = 0; round < rounds && !seen.is_full(); ++round) {
    const dvec3 point = seen.farthest(hole.center, reach);
    const double bound = seen.nearest(point).distance;
    if (bound <= close_enough * best.clearance) {
      break;
    }
    Nearest found{several_surfaces, static_cast<float>(close_enough * bound)};
    for (const SurfaceId id : near) {
      surfaces.consider(id, point, found);
    }
    surfaces.consider(target_surface, point, found);
    if (found.id == several_surfaces) {
      break;  // none is where it was seen: distances are measured to vertices only
    }
    if (found.clearance > best.clearance) {
      best = {point, found.clearance, found.id};
    }
    see(found.id, point, found.clearance);
  }
  return best;
}

}  // namespace collage
