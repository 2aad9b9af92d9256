#pragma once

#include <span>
#include <string_view>

#include "geometry/mesh.h"

namespace collage {

// The program's own models. All are closed, face outwards and have smooth normals; all but teapot
// and teacup are two-manifold without self-intersections, their parts being shells that do not
// touch. y is up, and what has a foot stands on y = 0.

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

/// A carrot, tip down, with five fronds of greens, each a part of its own just off the crown;
/// 3.5 tall.
Mesh make_carrot();

/// A top hat of felt with a satin ribbon, hollow, its brim curled up at +x and -x; about 2 wide.
Mesh make_top_hat();

// Breakfast in centimetres: a bowl 16 wide, and cereal and spoon of a size to go with it.

/// A bowl with a foot ring, glazed white, and blue outside.
Mesh make_bowl();
/// What the bowl holds when heaped: its hollow, a small gap within the wall, with a low dome that
/// rises over the rim.
Mesh make_bowl_inside();
/// Milk that stands in the bowl, half a centimetre below the rim.
Mesh make_bowl_milk();
/// A spoon that points to +x, of steel.
Mesh make_spoon();
/// A small thick ring of oats.
Mesh make_cereal_ring();
/// A wide, thin, wavy loop.
Mesh make_cereal_loop();
/// A curled flake of maize with an uneven rim.
Mesh make_cereal_flake();
/// A star with five rounded points.
Mesh make_cereal_star();
/// A puffed, lumpy ball.
Mesh make_cereal_puff();

/// A turned wooden chair with spindles and a curved crest, its parts just off each other, 2 tall;
/// it faces +z.
Mesh make_chair();
/// A chair to fill: one part, with stout legs, rails and slats, 2 tall.
Mesh make_chair_target();

/// A thin cloth over a ball of radius 1 that is not there, hanging down in folds to y = 0.
Mesh make_drape();

// Three families of shapes of high genus, after those that Muhm 2011, Fig. 20, made in TopMod
// (Akleman et al. 2008, "TopMod3D: an interactive topological mesh modeler"); each about 2 wide
// and lacquered. The targets are finer and fuller than the elements beside them.

/// Handles between the faces of a polyhedron, rounded off by Doo and Sabin's subdivision.
Mesh make_handled_cube();
Mesh make_handled_octahedron();
Mesh make_handled_tetrahedron();
Mesh make_handled_target();
/// Hollow polyhedra with a window in each face, smoothed by
/// subdivision.
Mesh make_rind_tetrahedron();
Mesh make_rind_prism();
Mesh make_rind_octahedron();
Mesh make_rind_target();
/// Hoops on the great circles of a polyhedron, woven over and under each other; and a knot.
Mesh make_woven_octahedron();
Mesh make_woven_cuboctahedron();
Mesh make_trefoil();
Mesh make_woven_target();

/// What `collage model NAME` makes.
struct StarterModel {
  std::string_view name;
  std::string_view description;
  Mesh (*make)();
};
std::span<const StarterModel> starter_models();

}  // namespace collage
