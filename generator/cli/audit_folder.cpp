#include "cli/audit_folder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "base/stage.h"
#include "base/text.h"
#include "cli/finished_folder.h"
#include "scene/povray_reader.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

/// The same placement, but for the last places of double.
bool same_placement(const PovrayScene::Instance& pov, const Instance& instance) {
  const dvec3 origin(0.0);
  const dvec3 translation = instance.world_from_element(origin);
  for (int column = 0; column < 4; ++column) {
    dvec3 wanted = translation;
    if (column < 3) {
      dvec3 axis(0.0);
      axis[column] = instance.scale;
      wanted = instance.rotation * axis;
    }
    for (int row = 0; row < 3; ++row) {
      const int at = 3 * column + row;
      const double got = pov.matrix[static_cast<std::size_t>(at)];
      const double size = instance.scale + (column == 3 ? glm::length(translation) : 0.0);
      if (!(std::abs(got - wanted[row]) <= 1e-12 * size)) {
        return false;
      }
    }
  }
  return true;
}

bool same_shape(const PovrayScene& scene, const std::string& name, const Mesh& mesh) {
  const auto found = scene.meshes.find(name);
  return found != scene.meshes.end() && found->second.positions == mesh.positions &&
         found->second.triangles == mesh.triangles;
}

/// What scene.pov says otherwise than sculpture.json and the meshes; empty: nothing. Each
/// instance stands there once, under its number in the order of placement.
std::string scene_difference(const fs::path& folder, const FinishedFolder& finished) {
  PovrayScene scene;
  try {
    scene = read_povray(folder / "scene.pov");
  } catch (const Error& error) {
    return error.what();
  }
  if (finished.target && !same_shape(scene, "Target", *finished.target)) {
    return "the target's mesh differs";
  }
  for (std::size_t e = 0; e < finished.elements.size(); ++e) {
    if (!same_shape(scene, fmt::format("Element_{}", e), finished.elements[e])) {
      return fmt::format("the mesh of element {} differs", e);
    }
  }
  const auto& instances = finished.sculpture.instances;
  if (scene.instances.size() != instances.size()) {
    return fmt::format("holds {} instances, not {}", grouped(scene.instances.size()),
                       grouped(instances.size()));
  }
  std::vector<bool> seen(instances.size());
  for (const PovrayScene::Instance& pov : scene.instances) {
    const bool known = pov.number < instances.size() && !seen[pov.number];
    if (!known || pov.element != instances[pov.number].element ||
        !same_placement(pov, instances[pov.number])) {
      return fmt::format("line {} places another instance than sculpture.json", pov.line);
    }
    seen[pov.number] = true;
  }
  return "";
}

/// Under the scene's rules: in the hole that was found, or in one as large as none can be.
FolderAudit::StillFits still_fits(const FinishedFolder& finished, const Measures& measures) {
  using StillFits = FolderAudit::StillFits;
  if (!measures.largest_hole || !measures.largest_hole->proven) {
    return StillFits::undecided;
  }
  const Scene& scene = finished.sculpture.options;
  const double side = measures.target_side;
  double needed = scene.packing.threshold * side;
  if (scene.packing.scaling == Scaling::fixed) {
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t e = 0; e < scene.elements.size(); ++e) {
      const double scale = *std::ranges::min_element(scene.elements[e].scales);
      smallest = std::min(smallest, scale * finished.sculpture.elements[e].size);
    }
    needed = std::max(needed, smallest);
  }
  needed += scene.packing.spacing * side;
  return measures.largest_hole->radius >= needed ? StillFits::yes
         : measures.largest_hole->bound < needed ? StillFits::no
                                                 : StillFits::undecided;
}

}  // namespace

FolderAudit audit_folder(const fs::path& folder, const FinishedFolder& finished, Status& status,
                         Measuring measuring) {
  const Scene& scene = finished.sculpture.options;
  AuditInput input;
  input.target = finished.target ? &*finished.target : nullptr;
  for (std::size_t e = 0; e < finished.elements.size(); ++e) {
    const bool fixed = scene.packing.scaling == Scaling::fixed;
    input.elements.push_back(&finished.elements[e]);
    input.scales.push_back(fixed ? scene.elements[e].scales : std::vector<double>{});
  }
  input.instances = finished.sculpture.instances;
  FolderAudit result;
  result.instances = input.instances.size();
  result.distances_exact = scene.packing.distance == Distance::exact;
  result.target_known = finished.target.has_value();
  {
    const Stage stage(status, "auditing");
    result.audit = audit(input, status);
    result.scene_difference = scene_difference(folder, finished);
  }
  if (measuring == Measuring::nothing) {
    return result;
  }
  const Stage stage(status, "measuring");
  MeasureInput measured;
  measured.target = input.target;
  measured.elements = input.elements;
  measured.instances = input.instances;
  result.measures = measure(measured, status);
  result.still_fits = still_fits(finished, result.measures);
  return result;
}

}  // namespace collage
