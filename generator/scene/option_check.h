#pragma once

#include <cstddef>
#include <filesystem>

#include "base/error.h"
#include "scene/mesh_library.h"
#include "scene/option.h"

namespace collage {

/// Who gives a value.
struct OptionSource {
  enum class Paths { resolve, keep };

  /// For messages; empty for the command line.
  Place place;
  /// Where relative paths start from.
  std::filesystem::path folder;
  /// `keep` takes paths as they are and does not look whether the files exist.
  Paths paths = Paths::resolve;
  MeshLibraries libraries{};
};

/// `value` in the form that Option::store takes: whole numbers become numbers where those are
/// meant, relative paths and names of meshes in libraries are resolved. Throws Error where the
/// value is of the wrong type, out of range, not one of the words, or names a file that does not
/// exist.
OptionValue checked(const Option& option, std::size_t element, const OptionValue& value,
                    const OptionSource& source);

}  // namespace collage
