#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/compare.h"

namespace collage {

/// One golden picture and what became of it.
struct GoldenRow {
  std::string name{};
  /// Empty: there is none.
  std::filesystem::path reference{};
  std::filesystem::path picture{};
  std::filesystem::path difference{};
  /// nullopt: there was nothing to compare; `problem` says why ("there is no reference").
  std::optional<Comparison> comparison{};
  std::string problem{};
};

/// Writes one page of HTML: reference, new picture and amplified difference side by side with the
/// numbers, failures first, and the command that makes the new pictures the references. Pictures
/// are linked relative to the page. Throws Error where it cannot be written.
void write_golden_report(const std::vector<GoldenRow>& rows, const std::string& update_command,
                         const std::filesystem::path& output);

}  // namespace collage
