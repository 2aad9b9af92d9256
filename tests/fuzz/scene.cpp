#include "fuzz.h"
#include "scene/scene_file.h"

using namespace collage;

/// A scene.toml, beside which there is a mesh.obj.
COLLAGE_FUZZ_TARGET(input) {
  fuzz::file_with("", "mesh.obj");
  read_scene(fuzz::file_with(input, "scene.toml"), {});
}
