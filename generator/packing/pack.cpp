#include "packing/pack.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "base/error.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "packing/climb.h"
#include "packing/update.h"

namespace collage {
namespace {

std::vector<const Element*> elements(std::span<const Ingredient> ingredients) {
  std::vector<const Element*> list;
  for (const Ingredient& ingredient : ingredients) {
    list.push_back(&ingredient.element);
  }
  return list;
}

/// Fills the next largest holes at the same time as long as their footprints do not meet. Whether
/// they were the next in turn shows only afterwards: one that was not, as an earlier element left a
/// larger hole, is taken back with all that came after it.
class Packer {
 public:
  Packer(const Target& target, ClearanceField& field, std::span<const Ingredient> ingredients,
         const PackingOptions& options)
      : field_(field),
        options_(options),
        longest_side_(target.box().longest_side()),
        placer_(ingredients, options, target.box()),
        surfaces_(target, elements(ingredients)),
        climb_reach_(options.climb ? field.grid().voxel_side : 0.0) {}

  Packing run(Status& status);

 private:
  struct Filling {
    Hole hole;
    ClearanceField::Peak peak;
    BlockRange footprint;
    std::optional<Instance> instance;
    Update update;
    std::vector<SurfaceId> neighbours;
  };

  /// The radius of the ball that an element may take in a hole.
  [[nodiscard]] double room(const Hole& hole) const {
    return hole.clearance - options_.spacing * longest_side_;
  }
  [[nodiscard]] double threshold() const { return options_.threshold * longest_side_; }

  static bool is_serial() { return tbb::this_task_arena::max_concurrency() == 1; }
  bool find_largest_hole(Filling& filling);
  void make_largest_exact();
  double largest_clearance();
  void find_holes();
  void climb(Filling& filling);
  void fill_holes();
  void close_if_unchanged(const ClearanceField::Peak& peak);
  bool accept(Packing& packing);
  void report(Status& status);

  ClearanceField& field_;
  const PackingOptions& options_;
  double longest_side_;
  Placer placer_;
  Surfaces surfaces_;
  /// How far a centre may move from its voxel's sample point; 0: it stays there.
  double climb_reach_;

  std::array<Filling, 64> fillings_;
  std::array<ClearanceField::Peak, 32> peaks_;
  std::size_t count_ = 0;
  double first_room_ = 0.0;
  std::size_t reported_ = 0;
};

Packing Packer::run(Status& status) {
  Packing packing;
  const Stopwatch total;
  find_holes();
  first_room_ = room(fillings_[0].hole);
  bool more = true;
  while (more && count_ > 0) {
    const Stopwatch updating;
    fill_holes();
    more = accept(packing);
    packing.update_seconds += updating.seconds();
    report(status);
    if (more && !surfaces_.instances().empty() && status.finish_requested()) {
      packing.complete = false;
      break;
    }
    if (more) {
      find_holes();
    }
  }
  packing.largest_hole = largest_clearance();
  packing.instances = surfaces_.take_instances();
  packing.voxels = field_.grid().size;
  packing.voxels_inside_target = field_.voxels_inside();
  packing.place_seconds = total.seconds() - packing.update_seconds;
  return packing;
}

/// False where none is large enough.
bool Packer::find_largest_hole(Filling& filling) {
  const float least = placer_.least_clearance();
  for (auto peak = field_.peak(); peak && peak->upper >= least; peak = field_.peak()) {
    const NearestSurface nearest = field_.block(peak->block).nearest[peak->slot];
    if (nearest.is_exact()) {
      filling.peak = *peak;
      filling.hole = {field_.sample_point(*peak), peak->upper, nearest.id()};
      return room(filling.hole) >= threshold();
    }
    make_largest_exact();
  }
  return false;
}

/// Finds the exact clearances of the next largest peaks at the same time. Some of them will change
/// before their turn comes, which costs time but changes nothing.
void Packer::make_largest_exact() {
  const float least = placer_.least_clearance();
  const std::size_t most = is_serial() ? 1 : peaks_.size();
  std::size_t count = 0;
  for (; count < most; ++count) {
    const auto peak = field_.peak();
    if (!peak || peak->upper < least) {
      break;
    }
    peaks_[count] = *peak;
    field_.set_block_maximum(peak->block, -1.0F);  // to come to the next
  }
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    ClearanceField::Peak& peak = peaks_[i];
    if (!field_.block(peak.block).nearest[peak.slot].is_exact()) {
      peak.upper = make_exact(field_, surfaces_, peak, least);
    }
  });
  for (std::size_t i = 0; i < count; ++i) {
    field_.set_block_maximum(peaks_[i].block, peaks_[i].upper);
  }
}

/// The clearance of the largest hole, however small.
double Packer::largest_clearance() {
  while (const auto peak = field_.peak()) {
    const float maximum = make_exact(field_, surfaces_, *peak, placer_.least_clearance());
    field_.set_block_maximum(peak->block, maximum);
    if (field_.block(peak->block).upper[peak->slot] == peak->upper) {
      return peak->upper;
    }
  }
  return 0.0;
}

void Packer::find_holes() {
  const std::size_t most = is_serial() ? 1 : fillings_.size();
  for (count_ = 0; count_ < most; ++count_) {
    Filling& next = fillings_[count_];
    if (!find_largest_hole(next)) {
      break;
    }
    // Climbing may move the centre by the reach and add as much to the clearance, which counts
    // twice; twice the reach is the margin of the update.
    next.footprint = footprint(field_.grid(), next.hole, 5.0 * climb_reach_);
    const bool meets_another =
        std::any_of(fillings_.begin(), fillings_.begin() + static_cast<std::ptrdiff_t>(count_),
                    [&](const Filling& f) { return ranges_meet(f.footprint, next.footprint); });
    if (meets_another) {
      break;
    }
    field_.set_block_maximum(next.peak.block, -1.0F);  // out of the way of the next
  }
  for (std::size_t i = 0; i < count_; ++i) {
    field_.set_block_maximum(fillings_[i].peak.block, fillings_[i].peak.upper);
  }
}

/// Neighbours in footprints that do not meet are too far off to matter.
void Packer::climb(Filling& filling) {
  filling.neighbours.clear();
  field_.for_each_neighbour(filling.peak.block,
                            [&](SurfaceId id) { filling.neighbours.push_back(id); });
  std::ranges::sort(filling.neighbours);
  filling.hole = climbed(surfaces_, filling.hole, filling.neighbours,
                         std::min(climb_reach_, filling.hole.clearance));
}

void Packer::fill_holes() {
  const std::size_t first = surfaces_.instances().size();
  if (first + count_ > most_surfaces) {
    throw Error(fmt::format("more than {} instances", grouped(most_surfaces)),
                "raise packing.threshold");
  }
  surfaces_.resize(first + count_);
  tbb::parallel_for(std::size_t{0}, count_, [&](std::size_t i) {
    Filling& filling = fillings_[i];
    if (climb_reach_ > 0.0) {
      climb(filling);
    }
    filling.instance = placer_.place(filling.hole, first + i, surfaces_);
    if (filling.instance) {
      surfaces_.set(first + i, *filling.instance);
      update(field_, surfaces_, static_cast<SurfaceId>(first + i + 1), filling.hole,
             placer_.least_clearance(), 2.0 * climb_reach_, filling.update);
    }
  });
}

/// A thin element round a centre that moved may leave its voxel as large a hole as before.
void Packer::close_if_unchanged(const ClearanceField::Peak& peak) {
  const float& upper = field_.block(peak.block).upper[peak.slot];
  if (upper == peak.upper) {
    field_.set_block_maximum(peak.block,
                             make_exact(field_, surfaces_, peak, placer_.least_clearance()));
  }
  if (upper == peak.upper) {
    field_.close(peak);
  }
}

/// Commits the fillings that were in turn, and undoes the others. False where no element is small
/// enough for the largest hole.
bool Packer::accept(Packing& packing) {
  const std::size_t first = surfaces_.instances().size() - count_;
  float largest_left = -1.0F;
  std::size_t accepted = 0;
  bool fits = true;
  for (; accepted < count_; ++accepted) {
    const Filling& filling = fillings_[accepted];
    if (filling.peak.upper <= largest_left) {
      break;
    }
    if (!filling.instance) {
      fits = placer_.fits_elsewhere(filling.hole);
      if (fits) {
        field_.close(filling.peak);
      }
      break;
    }
    commit(field_, filling.update);
    packing.voxels_inside_instances += filling.update.voxels_flagged;
    if (climb_reach_ > 0.0) {
      close_if_unchanged(filling.peak);
    }
    for (const Update::Maximum& maximum : filling.update.maxima) {
      largest_left = std::max(largest_left, maximum.upper);
    }
  }
  for (std::size_t i = accepted; i < count_; ++i) {
    if (fillings_[i].instance) {
      undo(field_, fillings_[i].update);
    }
  }
  surfaces_.resize(first + accepted);
  return fits;
}

/// Holes shrink steadily on a scale of logarithms, and each octave of them costs about the same.
void Packer::report(Status& status) {
  const std::size_t placed = surfaces_.instances().size();
  if (placed < reported_) {
    return;
  }
  reported_ = placed + 64;
  if (status.stop_requested()) {
    throw Interrupted();
  }
  const double last_room = room(fillings_[0].hole);
  const double fraction = std::log(first_room_ / last_room) / std::log(first_room_ / threshold());
  status.update(std::min(fraction, 1.0), fmt::format("{} instances", grouped(placed)));
}

}  // namespace

Packing pack(const Target& target, ClearanceField& field, std::span<const Ingredient> ingredients,
             const PackingOptions& options, Status& status) {
  return Packer(target, field, ingredients, options).run(status);
}

double fill(const Target& target, std::span<const Ingredient> ingredients,
            std::span<const Instance> instances) {
  double volume = 0.0;
  for (const Instance& instance : instances) {
    const double scale = instance.scale;
    volume += scale * scale * scale * ingredients[instance.element].element.solid().volume();
  }
  return volume / target.volume();
}

}  // namespace collage
