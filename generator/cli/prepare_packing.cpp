#include "cli/prepare_packing.h"

#include <algorithm>
#include <cstdint>
#include <memory>

#include <fmt/format.h>

#include "base/error.h"
#include "base/memory.h"
#include "fitting/pack_by_shape.h"
#include "fitting/shape_cache.h"

namespace collage {
namespace {

bool same_shape(const Mesh& a, const Mesh& b) {
  return a.positions == b.positions && a.triangles == b.triangles;
}

/// The first mesh that is the same as that of element `e`.
std::size_t first_of_its_shape(const std::vector<const Mesh*>& meshes, std::size_t e) {
  std::size_t first = 0;
  while (!same_shape(*meshes[first], *meshes[e])) {
    ++first;
  }
  return first;
}

/// The elements by their shapes, each different shape once, and the space to fill.
struct ShapeWorkshop {
  ShapeWorkshop(const Scene& scene, const PackingInput& input, Status& status);
  ShapeWorkshop(const ShapeWorkshop&) = delete;
  ShapeWorkshop& operator=(const ShapeWorkshop&) = delete;

  std::unique_ptr<CollisionShape> surface;
  std::vector<std::unique_ptr<ShapedElement>> shapes;
  /// Those of the elements that were measured before it was asked to finish, one at least.
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
    const std::size_t first = first_of_its_shape(input.meshes, e);
    if (first < e) {
      shape_of.push_back(shape_of[first]);
      continue;
    }
    if (status.stop_requested()) {
      throw Interrupted();
    }
    if (e > 0 && status.finish_requested()) {
      status.note(
          fmt::format("the last {} of {} elements are left out: there was no time to measure "
                      "their shapes",
                      input.meshes.size() - e, input.meshes.size()));
      break;
    }
    status.update(static_cast<double>(e) / static_cast<double>(input.meshes.size()),
                  scene.elements[e].name());
    const Element& element = input.ingredients[e].element;
    shape_of.push_back(shapes.size());
    shapes.push_back(std::make_unique<ShapedElement>(
        *input.meshes[e], element, cached_shape(*input.meshes[e], element, cache)));
  }
  for (std::size_t e = 0; e < shape_of.size(); ++e) {
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

/// Only holes of spheres have a centre, and where distances may be too large, the way to a wider
/// hole may lead through a surface.
void require_sound_climbing(const Scene& scene) {
  if (scene.packing.climb && scene.packing.fit == Fit::shape) {
    throw Error({scene.file}, "packing.climb does not go with packing.fit = \"shape\"",
                "use packing.fit = \"sphere\"");
  }
  if (scene.packing.climb && scene.packing.distance == Distance::vertices) {
    throw Error({scene.file}, "packing.climb does not go with packing.distance = \"vertices\"",
                "use packing.distance = \"exact\"");
  }
}

/// An upper bound, mostly within a factor of two, of what packing takes, in bytes. What an instance
/// takes is little beside the voxels at its place.
class MemoryEstimate {
 public:
  MemoryEstimate(const Scene& scene, const PackingInput& input)
      : target_(input.target), by_sphere_(scene.packing.fit == Fit::sphere) {
    fixed_ += bytes_a_triangle * input.target_mesh.triangles.size();
    for (std::size_t e = 0; e < input.meshes.size(); ++e) {
      fixed_ += bytes_a_triangle * input.meshes[e]->triangles.size();
      if (!by_sphere_ && first_of_its_shape(input.meshes, e) == e) {
        fixed_ += bytes_a_shape;
      }
    }
  }

  [[nodiscard]] std::uint64_t bytes(int resolution) const {
    const VoxelGrid grid = target_.voxels(resolution, 0.0, 0);
    const std::uint64_t voxels = grid.block_count() * VoxelGrid::block_voxels;
    return fixed_ + voxels * (by_sphere_ ? bytes_a_voxel : bytes_a_lattice_point);
  }

 private:
  static constexpr std::uint64_t bytes_of_program = 50'000'000;  // with its libraries and threads
  static constexpr std::uint64_t bytes_a_shape = 20'000'000;     // covers, grid of distances
  static constexpr std::uint64_t bytes_a_triangle = 700;         // positions and hierarchies
  static constexpr std::uint64_t bytes_a_voxel = 16;  // 8, and what it takes to undo an update
  static constexpr std::uint64_t bytes_a_lattice_point = 12;  // 8, and blocks with their residents

  const Target& target_;
  bool by_sphere_;
  std::uint64_t fixed_ = bytes_of_program;
};

/// Throws Error, with the resolution that would do, before memory is taken.
void require_memory_for(const Scene& scene, const PackingInput& input) {
  if (input.target_mesh.triangles.empty()) {
    return;  // the voxels are the file's own
  }
  const MemoryEstimate estimate(scene, input);
  const std::uint64_t limit = memory_to_take();
  const std::uint64_t needed = estimate.bytes(scene.target.resolution);
  if (needed <= limit) {
    return;
  }
  int fitting = scene.target.resolution;
  while (fitting > 0 && estimate.bytes(fitting) > limit) {
    fitting -= 1 + fitting / 100;
  }
  const std::string lower = fitting > 0 ? fmt::format("lower target.resolution to {}", fitting)
                                        : "use meshes of fewer triangles";
  throw Error({scene.file},
              fmt::format("packing would take {:.2f} GB of memory and {:.2f} GB may be taken",
                          static_cast<double>(needed) / 1e9, static_cast<double>(limit) / 1e9),
              lower + ", or raise --memory-limit");
}

}  // namespace

std::function<Packing(Status&)> prepare_packing(const Scene& scene, const PackingInput& input,
                                                Status& status) {
  require_stretches(scene);
  require_sound_climbing(scene);
  require_memory_for(scene, input);
  if (scene.packing.fit == Fit::shape) {
    refuse_stretches(scene);
    const auto workshop = std::make_shared<ShapeWorkshop>(scene, input, status);
    return [&scene, &target = input.target, workshop](Status& packing_status) {
      Packing packing = pack_by_shape({target, workshop->surface.get()}, workshop->space,
                                      workshop->ingredients, scene.packing, packing_status);
      packing.complete &= workshop->ingredients.size() == scene.elements.size();
      return packing;
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
