#include "fuzz.h"
#include "scene/sculpture_file.h"

using namespace collage;

COLLAGE_FUZZ_TARGET(input) { read_sculpture(fuzz::file_with(input, "sculpture.json")); }
