#include "cli/prepare_packing.h"

#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "base/error.h"
#include "fitting/pack_by_shape.h"
#include "fitting/shape_cache.h"

namespace collage {
namespace {

bool same_shape(const Mesh& a, const Mesh& b) {
  return a.positions == b.positions && a.triangles == b.triangles;
}

/// The elements by their shapes, each different shape once, and the space to fill.
struct ShapeWorkshop {
  ShapeWorkshop(const Scene& scene, const PackingInput& input, Status& status);
  ShapeWorkshop(const ShapeWorkshop&) = delete;
  ShapeWorkshop& operator=(const ShapeWorkshop&) = delete;

  std::unique_ptr<CollisionShape> surface;
  std::vector<std::unique_ptr<ShapedElement>> shapes;
  std::vector<ShapeIngredient> ingredients;
  FreeSpace space;
};

ShapeWorkshop::ShapeWorkshop(const Scene& scene, const PackingInput& input, Status& status)
    : space(input.target, scene.target.resolution, status) {
  if (const auto* target = dynamic_cast<const MeshTarget*>(&input.target)) {
    surface = std::make_unique<CollisionShape>(input.target_mesh, target->solid());
  }
  const std::filesystem::path cache = cache_folder();
  std::vector<std::size_t> shape_of;
  for (std::size_t e = 0; e < input.meshes.size(); ++e) {
    std::size_t first = 0;
    while (!same_shape(*input.meshes[first], *input.meshes[e])) {
      ++first;
    }
    if (first < e) {
      shape_of.push_back(shape_of[first]);
      continue;
    }
    if (status.stop_requested()) {
      throw Interrupted();
    }
    status.update(static_cast<double>(e) / static_cast<double>(input.meshes.size()),
                  scene.elements[e].name());
    const Element& element = input.ingredients[e].element;
    shape_of.push_back(shapes.size());
    shapes.push_back(std::make_unique<ShapedElement>(
        *input.meshes[e], element, cached_shape(*input.meshes[e], element, cache)));
  }
  for (std::size_t e = 0; e < input.ingredients.size(); ++e) {
    const Ingredient& ingredient = input.ingredients[e];
    ingredients.push_back({*shapes[shape_of[e]], ingredient.scales, ingredient.weight});
  }
}

void require_stretches(const Scene& scene) {
  for (std::size_t e = 0; e < scene.elements.size(); ++e) {
    const Scene::Element& element = scene.elements[e];
    if (element.left > element.right) {
      throw Error({scene.file},
                  fmt::format("element.{0}.left = {1:g} is beyond element.{0}.right = {2:g}", e,
                              element.left, element.right),
                  "the stretch goes from left to right");
    }
  }
}

/// A hole has one place from which it is filled, which may lie in no element's stretch.
void refuse_stretches(const Scene& scene) {
  if (std::ranges::any_of(scene.elements, [](const Scene::Element& element) {
        return element.left > 0.0 || element.right < 1.0;
      })) {
    throw Error({scene.file},
                "element.left and element.right do not go with packing.fit = \"shape\"",
                "use packing.fit = \"sphere\"");
  }
}

}  // namespace

std::function<Packing(Status&)> prepare_packing(const Scene& scene, const PackingInput& input,
                                                Status& status) {
  require_stretches(scene);
  if (scene.packing.fit == Fit::shape) {
    refuse_stretches(scene);
    const auto workshop = std::make_shared<ShapeWorkshop>(scene, input, status);
    return [&scene, &target = input.target, workshop](Status& packing_status) {
      return pack_by_shape({target, workshop->surface.get()}, workshop->space,
                           workshop->ingredients, scene.packing, packing_status);
    };
  }
  const auto field = std::make_shared<ClearanceField>(
      input.target,
      input.target.voxels(scene.target.resolution, scene.target.jitter, scene.packing.seed),
      status);
  return [&scene, input, field](Status& packing_status) {
    return pack(input.target, *field, input.ingredients, scene.packing, packing_status);
  };
}

}  // namespace collage
