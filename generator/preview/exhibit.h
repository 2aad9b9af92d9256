#pragma once

#include <optional>
#include <vector>

#include "preview/framing.h"
#include "scene/composition.h"

namespace collage {

/// What of the sculpture is shown; the camera takes in all of it.
struct PreviewShown {
  /// Share of the instances, in order of placement; above 0, at most 1.
  double stage = 1.0;
  /// Index of the only element shown; nullopt: all.
  std::optional<std::uint32_t> element;

  bool operator==(const PreviewShown&) const = default;
};

/// What stands in the studio: copies of the elements' meshes, then of the props'.
struct Exhibit {
  std::vector<const Mesh*> meshes;
  /// In studio units; their elements are indices into `meshes`.
  std::vector<Instance> instances;
};

/// As the #if lines of scene.pov choose the instances; the props are always there. Refers to the
/// meshes of `composition`.
Exhibit exhibit_of(const Composition& composition, const PreviewShown& shown, const Stand& stand);

}  // namespace collage
