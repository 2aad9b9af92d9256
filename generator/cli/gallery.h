#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/make_scene.h"

namespace collage {

/// One sculpture of the gallery.
struct GalleryPiece {
  std::string scene;
  MadeScene made;
  /// The same with the settings nearest to the thesis's, packed and audited only; none where the
  /// scene has no thesis.toml.
  std::optional<Report> as_in_thesis;
};

/// Makes a still of each scene in `scene_folders` below `folder`, and packs its thesis.toml.
std::vector<GalleryPiece> make_gallery(const std::vector<std::filesystem::path>& scene_folders,
                                       const std::string& quality,
                                       const std::filesystem::path& folder,
                                       const RenderTools& tools);

/// Writes gallery.html, gallery.png (a contact sheet) and gallery.md (the thesis's Tables I and II
/// beside ours); returns where they are.
std::vector<std::filesystem::path> write_gallery(const std::vector<GalleryPiece>& pieces,
                                                 const std::filesystem::path& folder);

}  // namespace collage
