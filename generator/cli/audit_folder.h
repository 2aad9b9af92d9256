#pragma once

#include <filesystem>
#include <string>

#include "audit/audit.h"
#include "base/status.h"

namespace collage {

/// The promises, held against a finished folder.
struct FolderAudit {
  Audit audit;
  std::size_t instances = 0;
  /// What scene.pov says otherwise than sculpture.json and the meshes; empty: nothing.
  std::string scene_difference;
  /// packing.distance = "vertices" does not promise that nothing overlaps or sticks out.
  bool distances_exact = true;
  /// The target is a mesh, so that protrusions could be looked for.
  bool target_known = true;

  [[nodiscard]] bool passed() const {
    const bool apart = audit.overlaps.empty() && audit.protrusions.empty();
    return (apart || !distances_exact) && audit.deformed.empty() && scene_difference.empty();
  }
};

/// Reads sculpture.json, the meshes and scene.pov again and audits them.
FolderAudit audit_folder(const std::filesystem::path& folder, Status& status);

/// A short table, and the content of audit.json.
std::string audit_text(const FolderAudit& result);
std::string audit_json(const FolderAudit& result);

}  // namespace collage
