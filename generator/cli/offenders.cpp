#include "cli/offenders.h"

#include <set>

#include "base/error.h"
#include "base/file.h"
#include "scene/povray_writer.h"
#include "scene/sculpture_file.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

std::set<std::uint32_t> offending_instances(const Audit& audit) {
  std::set<std::uint32_t> offending;
  for (const Audit::Pair& pair : audit.overlaps) {
    offending.insert({pair.first, pair.second});
  }
  offending.insert(audit.protrusions.begin(), audit.protrusions.end());
  offending.insert(audit.deformed.begin(), audit.deformed.end());
  return offending;
}

/// The inputs and templates of a finished folder.
void copy_what_it_needs(const fs::path& source, const fs::path& folder) {
  for (const auto& entry : fs::recursive_directory_iterator(source)) {
    const fs::path relative = entry.path().lexically_relative(source);
    const bool needed = *relative.begin() == "meshes" || relative.extension() == ".inc";
    if (needed && entry.is_regular_file()) {
      write_file(folder / relative, read_file(entry.path()));
    }
  }
}

}  // namespace

void write_offenders(const fs::path& source, const FinishedFolder& finished, const Audit& audit,
                     const fs::path& folder, Status& status) {
  const std::set<std::uint32_t> offending = offending_instances(audit);
  if (offending.empty()) {
    status.note("no instance breaks a promise: nothing is written to " + folder.string());
    return;
  }
  if (fs::exists(folder) && fs::equivalent(source, folder)) {
    throw Error({folder}, "is the folder that is audited", "name another one");
  }
  Sculpture sculpture = finished.sculpture;
  sculpture.command = "collage audit --offenders";
  sculpture.instances.clear();
  for (const std::uint32_t i : offending) {
    sculpture.instances.push_back(finished.sculpture.instances[i]);
  }
  Composition composition = composition_of(finished);
  composition.instances = sculpture.instances;
  copy_what_it_needs(source, folder);
  write_povray(folder, composition, fs::path(sculpture.options.render.look).stem().string(),
               status);
  write_sculpture(folder / "sculpture.json", sculpture);
}

}  // namespace collage
