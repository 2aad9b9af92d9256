#include "scene/credit.h"

#include "scene/credit_json.h"

namespace collage {

namespace fs = std::filesystem;

std::optional<Credit> read_credit(const fs::path& mesh) {
  constexpr const char* remedy = "mend or remove it; it says whose work the mesh is";
  const fs::path file = fs::path(mesh).replace_extension(".credit.json");
  std::error_code ignored;  // what cannot be looked at does not exist for us
  if (!fs::exists(file, ignored)) {
    return std::nullopt;
  }
  const json_reader::json root = json_reader::parsed_file(file, remedy);
  try {
    return credit_from_json(root);
  } catch (const json_reader::Problem& problem) {
    throw json_reader::error_in(file, problem, remedy);
  }
}

}  // namespace collage
