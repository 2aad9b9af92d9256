#include "geometry/covering_spheres.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <queue>

#include <tbb/parallel_for.h>

#include "geometry/surface_points.h"

namespace collage {
namespace {

constexpr std::size_t surface_samples = 7000;
constexpr std::size_t most_vertices = 4000;
constexpr double lattice_points = 3000.0;
constexpr double finest_lattice = 0.045;
constexpr std::size_t word = 64;
constexpr double unbounded = std::numeric_limits<double>::infinity();

double depth_at(const Solid& solid, const dvec3& point) {
  return solid.inside(point) ? solid.surface().find(point, unbounded)->distance : 0.0;
}

/// The largest ball that touches the surface at `point` from inside, its radius being the depth of
/// its centre; of radius 0 where there is none.
Sphere ball_inside(const Solid& solid, const dvec3& point, const dvec3& normal) {
  constexpr int steps = 20;
  constexpr double touching = 0.995;
  double radius = 1.0;
  for (int step = 0; step < steps; ++step) {
    const auto closest = solid.surface().find(point - radius * normal, radius * touching);
    if (!closest) {
      break;
    }
    const dvec3 arm = point - closest->point;
    const double along = glm::dot(arm, normal);
    if (!(along > 0.0)) {
      return {point, 0.0};
    }
    const double smaller = glm::dot(arm, arm) / (2.0 * along);
    if (!(smaller < radius)) {
      break;
    }
    radius = smaller;
  }
  const dvec3 center = point - radius * normal;
  const double depth = depth_at(solid, center);
  return depth > 0.0 ? Sphere{center, depth} : Sphere{point, 0.0};
}

}  // namespace

SphereCoverer::SphereCoverer(const Solid& solid, const Mesh& unit_mesh) {
  add_samples(unit_mesh);
  add_lattice(solid);
  add_candidates(solid);
  group_samples(0, samples_.size());
}

void SphereCoverer::add_samples(const Mesh& unit_mesh) {
  for (const SurfacePoint& point : spread_over_surface(unit_mesh, surface_samples)) {
    samples_.push_back(point.position);
    normals_.push_back(point.normal);
  }
  std::vector<char> used(unit_mesh.positions.size(), 0);
  for (const uvec3& triangle : unit_mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      used[triangle[k]] = 1;
    }
  }
  const std::size_t stride = 1 + used.size() / most_vertices;
  for (std::size_t v = 0; v < used.size(); v += stride) {
    if (used[v] != 0) {
      samples_.push_back(unit_mesh.positions[v]);
      corners_.push_back(unit_mesh.positions[v]);
    }
  }
}

void SphereCoverer::add_lattice(const Solid& solid) {
  const double volume = solid.volume() / std::pow(solid.radius(), 3.0);
  const double side = std::max(finest_lattice, std::cbrt(std::abs(volume) / lattice_points));
  const int n = static_cast<int>(1.0 / side);
  const std::size_t count = 2 * static_cast<std::size_t>(n) + 1;
  std::vector<std::vector<dvec3>> layers(count);
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t layer) {
    const int k = static_cast<int>(layer) - n;
    for (int j = -n; j <= n; ++j) {
      for (int i = -n; i <= n; ++i) {
        const dvec3 point = side * dvec3(i, j, k);
        if (solid.inside(point)) {
          layers[layer].push_back(point);
        }
      }
    }
  });
  for (const std::vector<dvec3>& layer : layers) {
    lattice_.insert(lattice_.end(), layer.begin(), layer.end());
  }
  samples_.insert(samples_.end(), lattice_.begin(), lattice_.end());
}

void SphereCoverer::add_candidates(const Solid& solid) {
  candidates_.resize(normals_.size() + lattice_.size());
  tbb::parallel_for(std::size_t{0}, candidates_.size(), [&](std::size_t i) {
    const std::size_t l = i - normals_.size();
    candidates_[i] = i < normals_.size() ? ball_inside(solid, samples_[i], normals_[i])
                                         : Sphere{lattice_[l], depth_at(solid, lattice_[l])};
  });
  for (const dvec3& corner : corners_) {
    candidates_.push_back({corner, 0.0});
  }
}

void SphereCoverer::group_samples(std::size_t first, std::size_t last) {
  const auto begin = samples_.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = samples_.begin() + static_cast<std::ptrdiff_t>(last);
  Box box;
  std::for_each(begin, end, [&](const dvec3& sample) { box.include(sample); });
  if (last - first > word) {
    const std::size_t half = (last - first) / 2;
    const std::size_t middle = first + (half + word - 1) / word * word;
    const dvec3 e = box.extent();
    const int axis = e.x >= e.y && e.x >= e.z ? 0 : e.y >= e.z ? 1 : 2;
    std::nth_element(begin, samples_.begin() + static_cast<std::ptrdiff_t>(middle), end,
                     [axis](const dvec3& a, const dvec3& b) { return a[axis] < b[axis]; });
    group_samples(first, middle);
    group_samples(middle, last);
  } else if (first < last) {
    groups_.push_back({box.center(), 0.5 * glm::length(box.extent())});
  }
}

std::vector<SphereCoverer::Bits> SphereCoverer::covered_by_each(double bulge) const {
  constexpr double rounding = 1e-9;
  std::vector<Bits> covered(candidates_.size());
  tbb::parallel_for(std::size_t{0}, candidates_.size(), [&](std::size_t c) {
    const Sphere& candidate = candidates_[c];
    const double radius = candidate.radius + bulge;
    Bits& bits = covered[c];
    bits.assign(groups_.size(), 0);
    for (std::size_t w = 0; w < groups_.size(); ++w) {
      const Sphere& group = groups_[w];
      const double distance = glm::distance(group.center, candidate.center);
      if (distance + group.radius + rounding <= radius) {
        bits[w] = ~std::uint64_t{0};
      } else if (distance - group.radius - rounding <= radius) {
        const std::size_t end = std::min(samples_.size(), (w + 1) * word);
        for (std::size_t s = w * word; s < end; ++s) {
          const dvec3 arm = samples_[s] - candidate.center;
          bits[w] |= std::uint64_t{glm::dot(arm, arm) <= radius * radius} << (s % word);
        }
      }
    }
  });
  return covered;
}

std::vector<std::uint32_t> SphereCoverer::choose(double bulge, std::size_t limit) const {
  const std::vector<Bits> covered = covered_by_each(bulge);
  Bits left(groups_.size(), ~std::uint64_t{0});
  if (samples_.size() % word != 0) {
    left.back() >>= word - samples_.size() % word;
  }
  const auto gain = [&](std::uint32_t candidate) {
    std::size_t count = 0;
    for (std::size_t w = 0; w < left.size(); ++w) {
      count += static_cast<std::size_t>(std::popcount(covered[candidate][w] & left[w]));
    }
    return count;
  };
  // What a candidate covers can only shrink: one that still leads after a recount is the best.
  std::priority_queue<std::pair<std::size_t, std::uint32_t>> queue;
  for (std::uint32_t c = 0; c < candidates_.size(); ++c) {
    queue.emplace(gain(c), c);
  }
  std::size_t remaining = samples_.size();
  std::vector<std::uint32_t> chosen;
  while (remaining > 0 && !queue.empty() && chosen.size() < limit) {
    const std::uint32_t candidate = queue.top().second;
    queue.pop();
    const std::size_t now = gain(candidate);
    if (now == 0) {
      continue;
    }
    if (!queue.empty() && now < queue.top().first) {
      queue.emplace(now, candidate);
      continue;
    }
    chosen.push_back(candidate);
    remaining -= now;
    for (std::size_t w = 0; w < left.size(); ++w) {
      left[w] &= ~covered[candidate][w];
    }
  }
  return remaining == 0 ? chosen : std::vector<std::uint32_t>{};
}

SphereCover SphereCoverer::cover(std::size_t count) const {
  constexpr double tolerance = 1.03;
  SphereCover cover{0.0, {{dvec3(0.0), 1.0}}};
  double too_small = 0.002;
  double enough = 1.0;
  for (double bulge = 0.05; count > 1 && enough > tolerance * too_small;
       bulge = std::sqrt(too_small * enough)) {
    const std::vector<std::uint32_t> chosen = choose(bulge, count);
    if (chosen.empty()) {
      too_small = bulge;
      continue;
    }
    enough = bulge;
    cover = {bulge, {}};
    for (const std::uint32_t c : chosen) {
      cover.spheres.push_back({candidates_[c].center, candidates_[c].radius + bulge});
    }
  }
  return cover;
}

}  // namespace collage
