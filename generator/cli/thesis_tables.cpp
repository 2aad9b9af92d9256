#include "cli/thesis_tables.h"

namespace collage {

std::span<const ThesisSculpture> thesis_sculptures() {
  constexpr std::array<int, 3> cube{100, 100, 100};
  constexpr std::array<int, 3> letter{100, 100, 50};
  static constexpr std::array sculptures{
      ThesisSculpture{"teapot", cube, 1433, "300", 10.00, 11.04},
      ThesisSculpture{"bunny", cube, 2049, "208, 288", 18.08, 10.90},
      ThesisSculpture{"cereal", {100, 55, 100}, 565, "108–248", 12.25, 14.34},
      ThesisSculpture{"chair", cube, 3499, "1144", 44.88, 1.44},
      ThesisSculpture{"topmod1", cube, 2614, "72–480", 2.92, 13.82},
      ThesisSculpture{"topmod2", cube, 2303, "72–480", 2.23, 13.50},
      ThesisSculpture{"topmod3", cube, 2905, "72–480", 5.75, 14.73},
      ThesisSculpture{"collage-c", letter, 1584, "156, 172, 236", 3.62, 9.28},
      ThesisSculpture{"collage-o", letter, 452, "128, 128, 144", 1.23, 14.33},
      ThesisSculpture{"collage-l", letter, 323, "12, 52, 188", 0.87, 7.39},
      ThesisSculpture{"collage-a", letter, 585, "84, 304, 320", 2.55, 14.55},
      ThesisSculpture{"collage-g", letter, 1574, "304, 348, 452", 8.20, 8.84},
      ThesisSculpture{"collage-e", letter, 1128, "92, 192, 224", 2.15, 16.71},
      ThesisSculpture{"spheres", cube, std::nullopt, "–", std::nullopt, 72.87},
  };
  return sculptures;
}

}  // namespace collage
