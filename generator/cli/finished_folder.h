#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "base/status.h"
#include "geometry/mesh.h"
#include "scene/composition.h"
#include "scene/sculpture.h"

namespace collage {

/// What `pack` left in a folder, with its meshes read again.
struct FinishedFolder {
  Sculpture sculpture;
  std::vector<Mesh> elements;
  std::vector<Mesh> props;
  /// None where the target is a grid of distances.
  std::optional<Mesh> target;
};

/// Its sculpture.json alone. Throws Error where the folder holds none.
Sculpture read_finished_sculpture(const std::filesystem::path& folder);

/// Throws Error where the folder holds no sculpture, or an input is missing or not the one that the
/// sculpture was made from.
FinishedFolder read_finished_folder(const std::filesystem::path& folder, Status& status);

/// For the exporters; refers to the meshes and instances of `finished`, which must outlive it.
Composition composition_of(const FinishedFolder& finished);

}  // namespace collage
