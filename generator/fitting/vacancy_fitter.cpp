#include "fitting/vacancy_fitter.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace collage {
namespace {

constexpr std::uint64_t opening_stream = 0x6f70656e696e67ULL;

/// There are about as many elements above a size as its power of -2.4 (the exponent of sizes that
/// the audit finds): with this, large and small ones cost alike. Of what is spent on a hole a kind
/// gets its share.
double effort(double size_over_least, double share) {
  constexpr double exponent = 2.4;
  constexpr double at_least_size = 2.0;
  constexpr double most = 800.0;
  return std::max(1.0, share * std::min(most, at_least_size * std::pow(size_over_least, exponent)));
}

}  // namespace

VacancyFitter::VacancyFitter(const FreeSpace& space, const PlacedShapes& placed,
                             const PackingOptions& options, double spacing)
    : space_(space), placed_(placed), options_(options), spacing_(spacing), tools_([this] {
        return Tools(space_, spacing_);
      }) {}

bool VacancyFitter::blocks(const Kind& kind, const Pose& pose) const {
  return placed_.blocks(*kind.shape, pose, options_.linking, tools_.local().ids);
}

Pose VacancyFitter::polished(const Kind& kind, const SphereSet& spheres, const Pose& pose,
                             double least, Rng& rng) const {
  constexpr double hopeful = 0.93;
  Tools& tools = tools_.local();
  placed_.find_surroundings(pose, 0, tools.ids, tools.surroundings);
  tools.finder.optimizer().look_at(&tools.surroundings);
  const Pose better = tools.finder.optimizer().maximize(spheres, pose,
                                                        {.steps = 6,
                                                         .first_step = 0.06,
                                                         .largest_radius = kind.largest_radius,
                                                         .least_radius = hopeful * least},
                                                        rng);
  tools.finder.optimizer().look_at(nullptr);
  return better;
}

/// Candidates come by falling size: one is the best as soon as the next has been smaller.
Pose VacancyFitter::best_of(std::span<const Pose> candidates, const Vacancy& vacancy,
                            const Kind& kind, double least, Rng& rng) const {
  Pose best;
  for (const Pose& candidate : candidates) {
    if (candidate.radius <= best.radius) {
      break;
    }
    for (const SphereSet* spheres : {&kind.shape->fine(), &kind.shape->cautious()}) {
      const double enough = std::max(least, best.radius);
      const Pose pose = polished(kind, *spheres, candidate, enough, rng);
      if (pose.radius < enough) {
        break;  // nor will larger spheres get there
      }
      const auto fitting = shrunk(kind, pose, enough);
      if (fitting && (!vacancy.host || placed_.linked(*kind.shape, *fitting, *vacancy.host))) {
        best = *fitting;
        break;
      }
    }
  }
  return best;
}

void VacancyFitter::open(Vacancy& vacancy, const Kind& kind, double least,
                         std::uint64_t stream) const {
  Rng rng(options_.seed, opening_stream ^ mix_bits(stream));
  if (!vacancy.host) {
    const FreeSpace::Peak peak = space_.climb(vacancy.hole);
    vacancy.hole = peak.position;
    vacancy.clearance = peak.distance - spacing_;
  }
  vacancy.openings += 1;
  const double size_over_least = vacancy.key / (kind.least_radius * kind.key_per_radius);
  const Pose previous = vacancy.pose;
  vacancy.pose = Pose{};
  if (vacancy.host || vacancy.clearance > 0.3 * space_.distances().spacing()) {
    PoseFinder& finder = tools_.local().finder;
    const PoseFinder::Request request{.shape = *kind.shape,
                                      .hole = vacancy.hole,
                                      .least_radius = 0.9 * least,
                                      .largest_radius = kind.largest_radius,
                                      .effort = effort(size_over_least, kind.share),
                                      .previous = previous};
    const std::span<const Pose> candidates =
        vacancy.host ? finder.find_linked(request, placed_.opening_of(*vacancy.host), rng)
                     : finder.find(request, rng);
    vacancy.pose = best_of(candidates, vacancy, kind, least, rng);
  }
  vacancy.has_pose = vacancy.pose.radius > 0.0;
  vacancy.fitted_at = static_cast<std::uint32_t>(placed_.size());
}

bool VacancyFitter::is_ready(Vacancy& vacancy, const Kind& kind) const {
  constexpr double tolerance = 2e-3;
  const auto now = static_cast<std::uint32_t>(placed_.size());
  if (vacancy.has_pose && vacancy.fitted_at < now) {
    Tools& tools = tools_.local();
    placed_.find_surroundings(vacancy.pose, vacancy.fitted_at, tools.ids, tools.surroundings);
    if (!tools.surroundings.empty()) {
      PoseOptimizer& optimizer = tools.finder.optimizer();
      optimizer.look_at(&tools.surroundings);
      vacancy.has_pose = optimizer.violation(kind.shape->fine(), vacancy.pose) <= tolerance;
      optimizer.look_at(nullptr);
    }
    vacancy.fitted_at = now;
  }
  return vacancy.has_pose;
}

std::optional<Pose> VacancyFitter::shrunk(const Kind& kind, const Pose& pose, double least) const {
  for (const double factor : {1.0, 0.99, 0.975, 0.95, 0.92}) {
    Pose smaller = pose;
    smaller.radius *= factor;
    if (smaller.radius < least) {
      break;
    }
    if (!blocks(kind, smaller)) {
      return smaller;
    }
  }
  return std::nullopt;
}

std::optional<Pose> VacancyFitter::settled(const Kind& kind, const Pose& pose, double least) const {
  std::optional<Pose> best = shrunk(kind, pose, least);
  if (!best || best->radius < pose.radius) {
    return best;
  }
  for (const double factor : {1.01, 1.02, 1.04, 1.07, 1.11, 1.16}) {
    Pose larger = pose;
    larger.radius = std::min(kind.largest_radius, factor * pose.radius);
    if (larger.radius <= best->radius || blocks(kind, larger)) {
      break;
    }
    best = larger;
  }
  return best;
}

std::optional<Pose> VacancyFitter::settled_at_fixed(const Kind& kind, const Pose& pose) const {
  constexpr double rounding = 1.0 + 1e-9;
  const auto radius = std::ranges::find_if(
      kind.radii, [&](double listed) { return listed <= pose.radius * rounding; });
  if (radius == kind.radii.end()) {
    return std::nullopt;
  }
  Pose loose = pose;
  loose.radius = *radius;
  const Pose close = tools_.local().finder.optimizer().hug(kind.shape->fine(), loose);
  for (const Pose& candidate : {close, loose}) {
    if (!blocks(kind, candidate)) {
      return candidate;
    }
  }
  return std::nullopt;
}

}  // namespace collage
