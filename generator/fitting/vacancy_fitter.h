#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <tbb/enumerable_thread_specific.h>

#include "fitting/kinds.h"
#include "fitting/placed_shapes.h"

namespace collage {

/// Finds out how large an element may be in a vacancy, next to what is placed so far. Space and
/// placed instances are read only, and must outlive this; const members may run on many threads.
class VacancyFitter {
 public:
  /// `spacing` is the air to be kept, in world units.
  VacancyFitter(const FreeSpace& space, const PlacedShapes& placed, const PackingOptions& options,
                double spacing);

  /// Looks for the largest pose of at least radius `least` that the exact test allows, and gives it
  /// to the vacancy, or none. For large elements, of which there are few and which make up most of
  /// the volume, more is tried. Random numbers are those of the stream.
  void open(Vacancy& vacancy, const Kind& kind, double least, std::uint64_t stream) const;
  /// True where the vacancy's pose is known and, by the spheres, still fits.
  bool is_ready(Vacancy& vacancy, const Kind& kind) const;
  /// The pose grown or shrunk to where the exact test allows it; nothing where that is too small.
  [[nodiscard]] std::optional<Pose> settled(const Kind& kind, const Pose& pose, double least) const;
  /// With the largest radius listed, pushed against the surroundings.
  [[nodiscard]] std::optional<Pose> settled_at_fixed(const Kind& kind, const Pose& pose) const;

 private:
  /// What a thread works with.
  struct Tools {
    Tools(const FreeSpace& space, double margin) : finder(space, margin) {}

    PoseFinder finder;
    Surroundings surroundings;
    std::vector<std::uint32_t> ids;
  };

  [[nodiscard]] bool blocks(const Kind& kind, const Pose& pose) const;
  [[nodiscard]] std::optional<Pose> shrunk(const Kind& kind, const Pose& pose, double least) const;
  /// Made as large as the surroundings allow; given up where that is hardly going to be `least`.
  [[nodiscard]] Pose polished(const Kind& kind, const SphereSet& spheres, const Pose& pose,
                              double least, Rng& rng) const;
  [[nodiscard]] Pose best_of(std::span<const Pose> candidates, const Vacancy& vacancy,
                             const Kind& kind, double least, Rng& rng) const;

  const FreeSpace& space_;
  const PlacedShapes& placed_;
  const PackingOptions& options_;
  double spacing_;
  mutable tbb::enumerable_thread_specific<Tools> tools_;
};

}  // namespace collage
