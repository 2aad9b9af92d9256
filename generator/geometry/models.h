#pragma once

#include <span>
#include <string_view>

#include "geometry/mesh.h"

namespace collage {

/// The teapot of Newell 1975 ("The utilization of procedure models in digital image synthesis"),
/// its 28 patches and the four of the bottom that were added later, in his units: 6.4 wide, 3.15
/// tall; y is up, it stands on y = 0, the spout points to +x. Each patch becomes `segments` squared
/// quads. Three closed parts, which pass through each other: body with lid and bottom, handle,
/// spout. The slot between lid and rim, the ends of the handle and both ends of the spout, open in
/// the original, are sealed.
Mesh make_teapot(int segments);

/// A teacup of our own with foot ring, wall thickness and handle, glazed white; 2 wide, y is up,
/// it stands on y = 0, the handle points to +x. Two closed parts: the handle's ends lie within the
/// wall and never reach into the hollow. `segments` facets round the cup, at least 8.
Mesh make_teacup(int segments);

/// The unit sphere: an icosahedron whose triangles are split in four `subdivisions` times, with
/// all vertices on the sphere.
Mesh make_sphere(int subdivisions);

/// What `collage model NAME` makes.
struct StarterModel {
  std::string_view name;
  std::string_view description;
  Mesh (*make)();
};
std::span<const StarterModel> starter_models();

}  // namespace collage
