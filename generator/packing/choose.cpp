#include "packing/choose.h"

#include <algorithm>

namespace collage {

std::optional<Choice> Chooser::choose(double radius, std::size_t placed, Rng& rng,
                                      double across) const {
  std::vector<Choice> fitting;
  for (std::uint32_t e = 0; e < candidates_.size(); ++e) {
    const bool here = across >= candidates_[e].left && across <= candidates_[e].right;
    const auto scale = here ? best_scale(candidates_[e], radius) : std::nullopt;
    if (scale) {
      fitting.push_back({e, *scale});
    }
  }
  if (fitting.empty()) {
    return std::nullopt;
  }
  switch (choose_) {
    case Choose::alternate:
      return fitting[pick_next(fitting, placed)];
    case Choose::weighted:
      return fitting[pick_weighted(fitting, rng)];
    case Choose::largest:
      break;
  }
  return fitting[pick_largest(fitting, rng)];
}

bool Chooser::fits(double radius) const {
  return std::ranges::any_of(candidates_, [&](const Candidate& candidate) {
    return best_scale(candidate, radius).has_value();
  });
}

/// The largest allowed scale at which the candidate's sphere fits.
std::optional<double> Chooser::best_scale(const Candidate& candidate, double radius) const {
  if (scaling_ == Scaling::to_hole) {
    return radius / candidate.size;
  }
  std::optional<double> best;
  for (const double scale : candidate.scales) {
    if (scale * candidate.size <= radius && scale > best.value_or(0.0)) {
      best = scale;
    }
  }
  return best;
}

/// Elements of the same size, which all are where they are scaled to the hole, come up equally
/// often.
std::uint32_t Chooser::pick_largest(const std::vector<Choice>& fitting, Rng& rng) const {
  constexpr double equal = 1.0 - 1e-9;
  const auto size = [&](const Choice& c) { return c.scale * candidates_[c.element].size; };
  double largest = 0.0;
  for (const Choice& choice : fitting) {
    largest = std::max(largest, size(choice));
  }
  std::vector<std::uint32_t> tied;
  for (std::uint32_t i = 0; i < fitting.size(); ++i) {
    if (size(fitting[i]) >= largest * equal) {
      tied.push_back(i);
    }
  }
  return tied.size() == 1 ? tied[0] : tied[rng.below(tied.size())];
}

/// Elements take turns; one that does not fit loses its turn.
std::uint32_t Chooser::pick_next(const std::vector<Choice>& fitting, std::size_t placed) const {
  const auto turn = static_cast<std::uint32_t>(placed % candidates_.size());
  const auto next = std::find_if(fitting.begin(), fitting.end(),
                                 [turn](const Choice& choice) { return choice.element >= turn; });
  return next == fitting.end() ? 0 : static_cast<std::uint32_t>(next - fitting.begin());
}

std::uint32_t Chooser::pick_weighted(const std::vector<Choice>& fitting, Rng& rng) const {
  double total = 0.0;
  for (const Choice& choice : fitting) {
    total += candidates_[choice.element].weight;
  }
  double rest = rng.uniform() * total;
  for (std::uint32_t i = 0; i + 1 < fitting.size(); ++i) {
    rest -= candidates_[fitting[i].element].weight;
    if (rest < 0.0) {
      return i;
    }
  }
  return static_cast<std::uint32_t>(fitting.size() - 1);
}

}  // namespace collage
