#include "fuzz.h"
#include "scene/povray_reader.h"

using namespace collage;

COLLAGE_FUZZ_TARGET(input) { read_povray(fuzz::file_with(input, "scene.pov")); }
