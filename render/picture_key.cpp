#include "render/picture_key.h"

#include <algorithm>
#include <vector>

#include "base/error.h"
#include "base/file.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

bool is_scene_text(const fs::path& name) {
  return name.extension() == ".pov" || name.extension() == ".inc";
}

/// Plain files at the top of the folder but for hidden ones, in a fixed order.
std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const fs::path name = entry.path().filename();
    if (entry.is_regular_file() && !name.string().starts_with('.')) {
      names.push_back(name);
    }
  }
  std::ranges::sort(names);
  return names;
}

}  // namespace

std::string scene_digest(const fs::path& folder) {
  if (!fs::is_regular_file(folder / "scene.pov")) {
    throw Error({folder}, "there is no scene.pov here", "make it with: collage pack SCENE");
  }
  const std::vector<fs::path> names = files_in(folder);
  std::string text;
  for (const fs::path& name : names) {
    if (is_scene_text(name)) {
      text += name.string() + "\n" + read_file(folder / name);
    }
  }
  std::string listing = sha256(text) + "\n";
  for (const fs::path& name : names) {
    if (!is_scene_text(name) && text.find('"' + name.string() + '"') != std::string::npos) {
      listing += sha256(read_file(folder / name)) + " " + name.string() + "\n";
    }
  }
  return sha256(listing);
}

std::string picture_key(const std::string& scene_digest, const Shot& shot, const Povray& povray) {
  std::string text = scene_digest + "\n" + povray.version + "\n" + job_text(shot);
  for (const std::string& option : povray_options(shot)) {
    text += option + "\n";
  }
  return sha256(text);
}

}  // namespace collage
