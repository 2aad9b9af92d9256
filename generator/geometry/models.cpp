#include "geometry/models.h"

#include <array>

namespace collage {

std::span<const StarterModel> starter_models() {
  static constexpr std::array models = {
      StarterModel{"sphere", "a sphere of radius 1 with 1,280 triangles",
                   [] { return make_sphere(3); }},
      StarterModel{"teacup", "a teacup with handle and about 300 triangles",
                   [] { return make_teacup(14); }},
      StarterModel{"teapot", "Newell's teapot with about 6,500 triangles",
                   [] { return make_teapot(10); }},
      StarterModel{"carrot", "a carrot with its greens", make_carrot},
      StarterModel{"top-hat", "a top hat of felt with a satin ribbon", make_top_hat},
      StarterModel{"bowl", "a cereal bowl, 16 cm wide", make_bowl},
      StarterModel{"bowl-inside", "what the bowl holds when heaped, to be filled",
                   make_bowl_inside},
      StarterModel{"bowl-milk", "the milk in the bowl", make_bowl_milk},
      StarterModel{"spoon", "a spoon to go with the bowl", make_spoon},
      StarterModel{"cereal-ring", "a small thick ring of oats", make_cereal_ring},
      StarterModel{"cereal-loop", "a wide, wavy fruit loop", make_cereal_loop},
      StarterModel{"cereal-flake", "a curled flake of maize", make_cereal_flake},
      StarterModel{"cereal-star", "a star with five rounded points", make_cereal_star},
      StarterModel{"cereal-puff", "a puffed, lumpy ball", make_cereal_puff},
      StarterModel{"chair", "a turned chair with spindles", make_chair},
      StarterModel{"chair-target", "a stout chair with slats, to be filled", make_chair_target},
      StarterModel{"drape", "a cloth that hangs over a ball, to be filled", make_drape},
      StarterModel{"topmod1-a", "a cube with handles", make_handled_cube},
      StarterModel{"topmod1-b", "an octahedron with handles", make_handled_octahedron},
      StarterModel{"topmod1-c", "a tetrahedron with handles", make_handled_tetrahedron},
      StarterModel{"topmod1-target", "a dodecahedron with handles, to be filled",
                   make_handled_target},
      StarterModel{"topmod2-a", "a hollow tetrahedron with windows", make_rind_tetrahedron},
      StarterModel{"topmod2-b", "a hollow prism with windows", make_rind_prism},
      StarterModel{"topmod2-c", "a hollow octahedron with windows", make_rind_octahedron},
      StarterModel{"topmod2-target", "a hollow dodecahedron with windows, to be filled",
                   make_rind_target},
      StarterModel{"topmod3-a", "three hoops, woven", make_woven_octahedron},
      StarterModel{"topmod3-b", "four hoops, woven", make_woven_cuboctahedron},
      StarterModel{"topmod3-c", "a trefoil knot", make_trefoil},
      StarterModel{"topmod3-target", "six broad hoops, woven to a ball, to be filled",
                   make_woven_target},
  };
  return models;
}

}  // namespace collage
