#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace collage {

/// Whose work a mesh is. Texts are as the author gives them; any may be empty.
struct Credit {
  std::string title;
  std::string author;
  std::string licence;
  /// Where the work comes from, a URL.
  std::string link;
};

/// What stands in the JSON file beside a mesh, "cup.credit.json" for "cup.obj": an object of texts
/// with the names of the fields above. Nothing where there is no such file. Throws Error where the
/// file cannot be read or holds something else.
std::optional<Credit> read_credit(const std::filesystem::path& mesh);

}  // namespace collage
