#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "audit/audit.h"
#include "audit/measures.h"
#include "base/status.h"
#include "cli/finished_folder.h"

namespace collage {

/// The promises, held against a finished folder, and what there is to measure of it.
struct FolderAudit {
  /// Whether an element could still be placed in the largest hole under the scene's rules.
  enum class StillFits { no, yes, undecided };

  Audit audit;
  std::size_t instances = 0;
  /// What scene.pov says otherwise than sculpture.json and the meshes; empty: nothing.
  std::string scene_difference;
  /// packing.distance = "vertices" does not promise that nothing overlaps or sticks out.
  bool distances_exact = true;
  /// The target is a mesh, so that protrusions could be looked for.
  bool target_known = true;
  Measures measures;
  StillFits still_fits = StillFits::undecided;

  [[nodiscard]] bool passed() const {
    const bool apart = audit.overlaps.empty() && audit.protrusions.empty();
    return (apart || !distances_exact) && audit.deformed.empty() && scene_difference.empty();
  }
};

/// What is found out beside the promises.
enum class Measuring { all, nothing };

/// Holds `finished`, read again from `folder`, and scene.pov against the promises, and measures it.
FolderAudit audit_folder(const std::filesystem::path& folder, const FinishedFolder& finished,
                         Status& status, Measuring measuring = Measuring::all);

/// One result for people.
struct AuditLine {
  enum class Group { promise, likeness, density, variety };
  Group group;
  std::string name;
  std::string value;
  /// What the number is, in one sentence.
  std::string meaning;
};

std::vector<AuditLine> audit_lines(const FolderAudit& result);

/// "Nothing overlaps, …" or what is wrong.
std::string verdict_sentence(const FolderAudit& result);

/// A short table, and the content of audit.json.
std::string audit_text(const FolderAudit& result);
std::string audit_json(const FolderAudit& result);

}  // namespace collage
