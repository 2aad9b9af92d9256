#include <array>
#include <cmath>

#include "geometry/mesh_parts.h"
#include "geometry/model_materials.h"
#include "geometry/models.h"
#include "geometry/smooth_normals.h"
#include "geometry/sweep.h"

namespace collage {
namespace {

constexpr int segments = 16;
constexpr double ribbon_top = 0.36;
constexpr double crown_radius = 0.56;
constexpr double brim_radius = 1.0;

/// From the top of the hollow down, out along the underside of the brim, back, and up outside.
constexpr std::array<ProfilePoint, 11> profile = {{{0.0, 1.3},
                                                   {0.58, 1.3},
                                                   {0.515, 0.0},
                                                   {brim_radius, 0.02},
                                                   {0.985, 0.055},
                                                   {crown_radius + 0.02, 0.05},
                                                   {crown_radius + 0.01, ribbon_top},
                                                   {crown_radius - 0.012, ribbon_top + 0.004},
                                                   {0.655, 1.3},
                                                   {0.61, 1.36},
                                                   {0.0, 1.36}}};

/// The brim bends up at its sides and dips a little in front and behind.
dvec3 curled(const dvec3& p) {
  const double radius = std::hypot(p.x, p.z);
  const double out = glm::max(0.0, (radius - crown_radius) / (brim_radius - crown_radius));
  if (p.y > 0.2 || out == 0.0) {
    return p;
  }
  const double side = p.x * p.x / (radius * radius);
  return {p.x * (1.0 - 0.06 * out * side), p.y + out * out * (0.3 * side - 0.07), p.z};
}

}  // namespace

Mesh make_top_hat() {
  Mesh cloth;
  append_rings(cloth, lathe(profile, segments, 0.0));
  deform(cloth, curled);
  Mesh mesh;
  append_part(mesh, cloth, felt());
  paint(mesh, satin(), band_start(5, segments), band_start(7, segments));
  set_smooth_normals(mesh, 50.0);
  return mesh;
}

}  // namespace collage
