#include "geometry/mesh_repair.h"

#include "base/text.h"
#include "geometry/mesh_check.h"

namespace collage {

std::vector<std::string> repair(Mesh& mesh) {
  std::vector<std::string> lines;
  if (const std::size_t places = weld(mesh); places > 0) {
    lines.push_back("vertices welded: " + grouped(places));
  }
  if (const ClosedHoles closed = close_holes(mesh); closed.holes > 0) {
    lines.push_back("small holes closed: " + grouped(closed.holes) +
                    ", by new triangles: " + grouped(closed.triangles));
  }
  if (const std::string turned = text_of(orient(mesh)); !turned.empty()) {
    lines.push_back(turned);
  }
  return lines;
}

}  // namespace collage
