#pragma once

#include <optional>
#include <span>
#include <vector>

#include "audit/contacts.h"
#include "audit/fill.h"
#include "audit/kinds.h"
#include "audit/largest_hole.h"
#include "audit/links.h"
#include "audit/orientations.h"
#include "audit/silhouette.h"
#include "audit/sizes.h"
#include "audit/surface_distance.h"
#include "base/status.h"
#include "geometry/instance.h"
#include "geometry/mesh.h"

namespace collage {

/// What there is to say in numbers of a finished sculpture: how like the target it is, how varied,
/// how full. Whatever cannot be told of it is nothing: what needs the target's mesh where that is
/// not one, and what needs instances where there are none.
struct Measures {
  /// Longest side of the target's box; 0 where it is not known.
  double target_side = 0.0;
  std::optional<Silhouette> silhouette_iou;
  std::optional<SurfaceDistance> surface_distance;
  std::optional<Fill> fill;
  std::optional<LargestHole> largest_hole;
  std::optional<Contacts> contacts;
  std::optional<Links> links;
  /// Of the instances' enclosing spheres, their radii in world units.
  std::optional<Sizes> sizes;
  std::optional<Orientations> orientations;
  /// By the centres of the enclosing spheres.
  Kinds kinds;
};

struct MeasureInput {
  /// nullptr: the target is not a mesh.
  const Mesh* target = nullptr;
  /// Longest side of the target's box; 0: taken from the mesh, or else unknown.
  double target_side = 0.0;
  std::vector<const Mesh*> elements;
  std::span<const Instance> instances;

  SilhouetteOptions silhouette;
  SurfaceDistanceOptions surface_distance;
  FillOptions fill;
  /// How near two instances must come to count as touching, as a fraction of the target's longest
  /// side.
  double gap = 0.01;
};

/// Runs on all threads; the result does not depend on their number. Throws Interrupted where the
/// user stops it.
Measures measure(const MeasureInput& input, Status& status);

}  // namespace collage
