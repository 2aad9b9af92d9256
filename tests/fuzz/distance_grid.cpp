#include "geometry/distance_grid.h"

#include "fuzz.h"

using namespace collage;

COLLAGE_FUZZ_TARGET(input) { read_distance_grid(fuzz::file_with(input, "grid.sdf")); }
