#include "audit/largest_hole.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "base/error.h"
#include "geometry/topology.h"

namespace collage {
namespace {

constexpr double tolerance = 0.01;
constexpr double smallest_fraction = 1e-3;
constexpr int first_cubes_per_side = 16;
/// Cubes cut and looked at together; bounds the memory.
constexpr std::size_t batch = 1 << 16;

class Search {
 public:
  Search(const TargetShape& target, const InstanceIndex& sculpture, Status& status)
      : target_(target.solid),
        sculpture_(sculpture),
        status_(status),
        closed_(is_closed(target.mesh) &&
                std::ranges::all_of(sculpture.elements(),
                                    [](const Mesh* mesh) { return is_closed(*mesh); })),
        smallest_(smallest_fraction * target.side) {
    best_.proven = closed_;
    const Box& box = target.box;
    const double side = target.side / first_cubes_per_side;
    const glm::ivec3 count = glm::max(glm::ivec3(glm::ceil(box.extent() / side)), glm::ivec3(1));
    for (int z = 0; z < count.z; ++z) {
      for (int y = 0; y < count.y; ++y) {
        for (int x = 0; x < count.x; ++x) {
          first_cubes_.push_back(box.min + side * (dvec3(x, y, z) + 0.5));
        }
      }
    }
    first_side_ = side;
  }

  LargestHole run() {
    search(first_cubes_, first_side_, 0.0, 1.0);
    best_.bound = limit();
    return best_;
  }

 private:
  enum class State : std::uint8_t { unknown, taken, free };
  struct Clearance {
    /// To the nearest surface, on whichever side; the true one is in [distance - error, distance].
    double distance = 0.0;
    double error = 0.0;
    State state = State::unknown;

    [[nodiscard]] double at_least() const { return std::max(0.0, distance - error); }
  };

  /// Nothing above this is left unseen.
  [[nodiscard]] double limit() const {
    return std::max(best_.radius * (1.0 + tolerance), smallest_);
  }

  [[nodiscard]] Clearance clearance(const dvec3& point) const {
    const dvec3 unit = target_.unit_from_mesh(point);
    const auto wall = target_.surface().find(unit, std::numeric_limits<double>::infinity());
    Clearance result{wall->distance * target_.radius(),
                     ClosestPointIndex::error(unit) * target_.radius()};
    if (const auto nearest = sculpture_.nearest(point, result.distance)) {
      result.distance = nearest->distance;
      result.error = std::max(result.error, nearest->error);
    }
    return result;
  }
  [[nodiscard]] State state(const dvec3& point) const {
    const bool inside = target_.inside(target_.unit_from_mesh(point));
    return inside && !sculpture_.holder(point) ? State::free : State::taken;
  }

  /// Takes over the free points that are better than the best, then climbs from there.
  void improve(const std::vector<dvec3>& points, std::vector<Clearance>& clearances) {
    const double before = best_.radius;
    tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
      if (clearances[i].at_least() > before) {
        clearances[i].state = state(points[i]);
      }
    });
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (clearances[i].state == State::free && clearances[i].at_least() > best_.radius) {
        best_.center = points[i];
        best_.radius = clearances[i].at_least();
      }
    }
    if (best_.radius > before) {
      climb();
    }
  }

  /// Compass search: steps along the axes while they lead up, then half as long.
  void climb() {
    double step = 0.5 * best_.radius;
    while (step > 1e-3 * tolerance * best_.radius) {
      bool moved = true;
      while (moved) {
        moved = false;
        for (int side = 0; side < 6; ++side) {
          dvec3 point = best_.center;
          point[side / 2] += side % 2 == 0 ? step : -step;
          const double radius = clearance(point).at_least();
          if (radius > best_.radius * (1.0 + 1e-9) && state(point) == State::free) {
            best_.center = point;
            best_.radius = radius;
            moved = true;
          }
        }
      }
      step *= 0.5;
    }
  }

  enum class Fate : std::uint8_t { dropped, cut, undecided };

  /// A cube is dropped where it holds no clearance above the limit. One that is smaller than the
  /// error of its clearance, as an enormous instance brings, would not be decided by cutting.
  [[nodiscard]] Fate fate(const dvec3& point, Clearance& c, double half_diagonal) const {
    if (c.distance + half_diagonal <= limit()) {
      return Fate::dropped;
    }
    if (c.state == State::unknown) {
      c.state = state(point);
    }
    if (c.state == State::taken &&
        (closed_ ? half_diagonal - c.at_least() : 2.0 * half_diagonal) <= limit()) {
      return Fate::dropped;
    }
    return half_diagonal > c.error ? Fate::cut : Fate::undecided;
  }

  /// `begin` and `share`: which part of the whole work this is.
  void search(const std::vector<dvec3>& cubes, double side, double begin, double share) {
    if (status_.stop_requested()) {
      throw Interrupted();
    }
    status_.update(begin,
                   fmt::format("largest hole {:.4g}, at most {:.4g}", best_.radius, limit()));
    std::vector<Clearance> clearances(cubes.size());
    tbb::parallel_for(std::size_t{0}, cubes.size(),
                      [&](std::size_t i) { clearances[i] = clearance(cubes[i]); });
    improve(cubes, clearances);

    const double half_diagonal = 0.5 * std::sqrt(3.0) * side;
    std::vector<Fate> fates(cubes.size());
    tbb::parallel_for(std::size_t{0}, cubes.size(), [&](std::size_t i) {
      fates[i] = fate(cubes[i], clearances[i], half_diagonal);
    });
    const auto kept = static_cast<std::size_t>(std::ranges::count(fates, Fate::cut));
    best_.proven &= std::ranges::find(fates, Fate::undecided) == fates.end();
    std::vector<dvec3> parts;
    parts.reserve(std::min(batch, 8 * kept));
    std::size_t done = 0;
    const auto descend = [&](std::size_t next) {
      const double per_cube = share / static_cast<double>(kept);
      search(parts, 0.5 * side, begin + static_cast<double>(done) * per_cube,
             static_cast<double>(next - done) * per_cube);
      parts.clear();
      done = next;
    };
    std::size_t taken = 0;
    for (std::size_t i = 0; i < cubes.size(); ++i) {
      if (fates[i] != Fate::cut) {
        continue;
      }
      ++taken;
      for (int k = 0; k < 8; ++k) {
        const dvec3 corner((k & 1) != 0 ? 1 : -1, (k & 2) != 0 ? 1 : -1, (k & 4) != 0 ? 1 : -1);
        parts.push_back(cubes[i] + 0.25 * side * corner);
      }
      if (parts.size() + 8 > batch || taken == kept) {
        descend(taken);
      }
    }
  }

  const Solid& target_;
  const InstanceIndex& sculpture_;
  Status& status_;
  bool closed_;
  double smallest_;
  std::vector<dvec3> first_cubes_;
  double first_side_ = 0.0;
  LargestHole best_;
};

}  // namespace

LargestHole find_largest_hole(const TargetShape& target, const InstanceIndex& sculpture,
                              Status& status) {
  return Search(target, sculpture, status).run();
}

}  // namespace collage
