#include "geometry/model_materials.h"

#include <utility>

namespace collage {
namespace {

Material surface(std::string name, const dvec3& color, double specular, double shininess) {
  Material material;
  material.name = std::move(name);
  material.color = color;
  material.specular = dvec3(specular);
  material.shininess = shininess;
  return material;
}

}  // namespace

Material glaze(std::string name, const dvec3& color) {
  return surface(std::move(name), color, 0.4, 250.0);
}
Material lacquer(const dvec3& color) { return surface("lacquer", color, 0.35, 200.0); }
Material cereal(const dvec3& color) { return surface("cereal", color, 0.06, 25.0); }
Material carrot_skin() { return surface("carrot", {0.80, 0.205, 0.022}, 0.08, 30.0); }
Material greens() { return surface("greens", {0.10, 0.25, 0.035}, 0.02, 10.0); }
Material felt() { return surface("felt", {0.085, 0.125, 0.20}, 0.04, 8.0); }
Material satin() { return surface("satin", {0.42, 0.018, 0.045}, 0.3, 60.0); }
Material wood() { return surface("wood", {0.33, 0.135, 0.05}, 0.12, 60.0); }
Material steel() { return surface("steel", {0.42, 0.42, 0.44}, 0.75, 400.0); }
Material milk() {
  Material material = surface("milk", {0.84, 0.82, 0.75}, 0.15, 80.0);
  material.emission = dvec3(0.15);  // light that goes in and comes out elsewhere
  return material;
}

}  // namespace collage
