#include "base/memory.h"
#include "fuzz.h"
#include "render/compare.h"

using namespace collage;

/// A picture as both sides of a comparison, once as PNG and once as OpenEXR.
COLLAGE_FUZZ_TARGET(input) {
  limit_memory(std::uint64_t{1} << 24);
  for (const char* name : {"picture.png", "picture.exr"}) {
    fuzz::accepting_errors([&] {
      const auto path = fuzz::file_with(input, name);
      compare_pictures(path, path);
    });
  }
}
