#include "cli/traced_shadows.h"

#include <optional>

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "cli/finished_folder.h"
#include "preview/exhibit.h"
#include "preview/studio.h"
#include "scene/composition_bounds.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

/// As Compute_Shadow chooses them.
ShadowFineness fineness(Quality quality) {
  switch (quality) {
    case Quality::draft:
      return {42, 32};
    case Quality::standard:
      return {42, 48};
    case Quality::fine:
      break;
  }
  return {63, 64};
}

std::string declaration_of(const FloorShadow& shadow, const FloorLight& light) {
  std::string text = "#version 3.7;\n#declare Given_Shadow_Light = array[6] {";
  for (const double number : {shadow.radius(), light.key.x, light.key.y, light.key.z,
                              light.key_width_degrees, light.key_share}) {
    text += number_text(number) + ",";
  }
  text.back() = '}';
  const auto count = static_cast<std::size_t>(shadow.control_count());
  const std::string size = "[" + std::to_string(count) + "]";
  text += ";\n#declare Given_Shadow = array" + size + size + " {\n";
  for (std::size_t row = 0; row < count; ++row) {
    char separator = '{';
    for (std::size_t i = 0; i < count; ++i) {
      text += separator + number_text(shadow.control_values()[row * count + i]);
      separator = ',';
    }
    text += row + 1 < count ? "},\n" : "}\n";
  }
  return text + "};\n";
}

}  // namespace

struct TracedShadows::Folder {
  fs::path path;
  FinishedFolder finished;
  Composition composition;
  CompositionBounds bounds;
  /// Whether scene.pov is the one that was written with sculpture.json.
  bool is_as_written;
  /// Of the last picture.
  PreviewShown shown;
  double ground = 0.0;
  std::optional<InstancedScene> sculpture;

  Folder(const fs::path& path_, Status& status)
      : path(path_),
        finished(read_finished_folder(path_, status)),
        composition(composition_of(finished)),
        bounds(bounds_of(composition)),
        is_as_written(finished.sculpture.scene_sha256 == sha256(read_file(path / "scene.pov"))) {}

  const InstancedScene& scene(const Shot& shot, const Stand& stand) {
    PreviewShown wanted{shot.stage, std::nullopt};
    if (shot.only_element) {
      wanted.element = static_cast<std::uint32_t>(*shot.only_element);
    }
    if (!sculpture || wanted != shown || stand.foot.y != ground) {
      const Exhibit exhibit = exhibit_of(composition, wanted, stand);
      sculpture.emplace(exhibit.meshes, exhibit.instances);
      shown = wanted;
      ground = stand.foot.y;
    }
    return *sculpture;
  }
};

TracedShadows::TracedShadows(Status& status) : status_(&status) {}
TracedShadows::~TracedShadows() = default;
TracedShadows::TracedShadows(TracedShadows&&) noexcept = default;
TracedShadows& TracedShadows::operator=(TracedShadows&&) noexcept = default;

std::string TracedShadows::declaration(const fs::path& folder, const Shot& shot) {
  const std::optional<FloorLight> light = floor_light(shot.look);
  if (!light) {
    return {};
  }
  if (!folder_ || folder_->path != folder) {
    try {
      folder_ = std::make_unique<Folder>(folder, *status_);
    } catch (const Error&) {
      return {};  // without sculpture.json or its meshes, scene.pov can still be rendered
    }
  }
  if (!folder_->is_as_written) {
    return {};
  }
  const Stand stand = stand_of(folder_->composition, folder_->bounds, standing(shot.look));
  const FloorShadow shadow(folder_->scene(shot, stand), stand, {shot.view.azimuth_degrees, 0.0},
                           *light, fineness(shot.quality));
  return declaration_of(shadow, *light);
}

}  // namespace collage
