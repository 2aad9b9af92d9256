#include "bench/bar.h"

namespace collage::bench {
std::vector<Group> sphere_bars() { return {}; }
}  // namespace collage::bench
